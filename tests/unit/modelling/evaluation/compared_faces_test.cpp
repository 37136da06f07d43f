// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What of a model is compared with another: areas, corners and planes of models made by hand.
#include "modelling/evaluation/compared_faces.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace jalon;

namespace {

using Chain = std::vector<Vec3>;

/// Anticlockwise seen from above; against: clockwise.
Chain level_box(double x0, double y0, double x1, double y1, double z, bool against = false) {
  Chain out{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
  if (against) out = {out[0], out[3], out[2], out[1]};
  return out;
}

size_t add_level(Model& model, const char* part_class, const std::vector<Chain>& chains) {
  Part part;
  part.part_class = part_class;
  model.parts.push_back(part);
  Face face;
  face.part = static_cast<uint32_t>(model.parts.size() - 1);
  face.plane = {{0, 0, 1}, chains[0][0].z};
  return model.add_face(face, chains);
}

FaceChoice choice_within(double angle_rad, double distance_m) {
  FaceChoice out;
  out.angle_rad = angle_rad;
  out.distance_m = distance_m;
  out.corner_angle_rad = 0.35;
  return out;
}

std::vector<ComparedFace> faces_of(const Model& model, const FaceChoice& choice) {
  Task task;
  return compared_faces(model, {}, choice, task);
}

}  // namespace

TEST_CASE("compared_faces__have_their_area_and_the_corners_where_rings_turn") {
  Model model;
  Chain outline = level_box(0, 0, 6, 4, 0);
  outline.insert(outline.begin() + 1, {3, 0, 0});       // on a straight edge
  outline.insert(outline.begin() + 3, {6.0005, 2, 0});  // hardly a turn: half a mrad
  add_level(model, "wall", {outline, level_box(1, 1, 2, 3, 0, true)});
  const auto faces = faces_of(model, choice_within(0.1, 0.1));
  REQUIRE(faces.size() == 1);
  // Corners are snapped to 0.1 mm of a border of 26 m.
  CHECK(std::fabs(faces[0].area_m2 - (24 + 0.001 - 2)) < 26e-4);
  CHECK(faces[0].vertices == std::vector<uint32_t>{0, 2, 4, 5, 6, 7, 8, 9});
  CHECK(norm(faces[0].box.max - Vec3{6.0005, 4, 0}) < 1e-9);
  CHECK(norm(faces[0].frame.normal - Vec3{0, 0, 1}) < 1e-12);
  // A semicircle on a straight edge: its ends count, though their chords do not turn.
  Model round;
  Chain straight = level_box(-1, 0, 2, 2, 0);
  straight.insert(straight.begin() + 1, {{0, 0, 0}, {1, 0, 0}});
  add_level(round, "door", {straight});
  round.sagittas = {0, 0.5, 0, 0, 0, 0};
  CHECK(faces_of(round, choice_within(0.1, 0.1))[0].area_m2 ==
        doctest::Approx(6 + std::numbers::pi / 8).epsilon(2e-4));
  CHECK(faces_of(round, choice_within(0.1, 0.1))[0].vertices.size() == 6);
}

TEST_CASE("compared_faces__are_chosen_by_class_kept_by_size_and_their_openings_looked_at_alone") {
  Model model;
  add_level(
      model, "wall",
      {level_box(0, 0, 6, 4, 0), level_box(1, 1, 2, 3, 0, true), level_box(4, 1, 5, 2, 0, true)});
  add_level(model, "roof", {level_box(0, 0, 1, 1, 5)});
  add_level(model, "no_data", {level_box(0, 0, 2, 2, 7)});
  add_level(model, "roof", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}});  // no area
  model.rings[2].part = 1;                                        // what fills the second opening
  FaceChoice choice = choice_within(0, 0);
  CHECK(faces_of(model, choice).size() == 3);
  choice.ignored_classes = {"no_data"};
  choice.min_area_m2 = 1.5;
  auto faces = faces_of(model, choice);
  REQUIRE(faces.size() == 2);
  CHECK(faces[0].kept);
  CHECK_FALSE(faces[1].kept);
  choice.classes = {"roof", "sky"};
  faces = faces_of(model, choice);
  REQUIRE(faces.size() == 1);
  CHECK(faces[0].part == 1);
  choice = choice_within(0, 0);
  choice.openings = true;
  faces = faces_of(model, choice);
  REQUIRE(faces.size() == 2);
  CHECK(faces[0].area_m2 == doctest::Approx(2).epsilon(1e-9));
  CHECK(faces[1].area_m2 == doctest::Approx(1).epsilon(1e-9));
  CHECK(faces[0].part == 0);
  CHECK(faces[1].part == 1);
  CHECK(faces[1].ring == 2);
  for (const ComparedFace& face : faces) CHECK(norm(face.frame.normal - Vec3{0, 0, 1}) < 1e-12);
}

TEST_CASE("compared_faces__of_one_plane_and_of_meshes_become_one") {
  Model model;
  add_level(model, "wall", {level_box(0, 0, 3, 4, 0)});
  add_level(model, "wall", {level_box(2, 0, 7, 4, 0.05)});  // overlaps by 4 m2
  add_level(model, "wall", {level_box(0, 0, 3, 4, 0.2)});
  FaceChoice choice = choice_within(0.01, 0.1);
  choice.by_plane = true;
  const auto planes = faces_of(model, choice);
  REQUIRE(planes.size() == 2);
  CHECK(planes[0].face == 1);  // the largest gives the plane
  CHECK(planes[0].merged == 2);
  CHECK(planes[0].region.size() == 1);  // without borders inside
  CHECK(planes[0].area_m2 == doctest::Approx(28).epsilon(1e-9));
  CHECK(planes[1].merged == 1);
  Model mesh;
  mesh.vertices = level_box(0, 0, 4, 2, 1);
  mesh.vertices.push_back({4, 1, 3});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};
  mesh.triangle_faces = {0, 0, 0};
  const auto of_mesh = faces_of(mesh, choice_within(0.01, 0.1));
  REQUIRE(of_mesh.size() == 2);
  CHECK(of_mesh[0].area_m2 == doctest::Approx(8).epsilon(1e-9));
  CHECK(of_mesh[1].area_m2 == doctest::Approx(2).epsilon(1e-9));
}

TEST_CASE("compared_faces__meet_a_plane_within_its_tolerances_and_are_projected_onto_it") {
  Model model;
  add_level(model, "a", {level_box(0, 0, 2, 2, 0)});
  const double tilt = 0.02;  // about the y axis
  model.add_face({}, {{{0, 0, 0},
                       {2 * std::cos(tilt), 0, 2 * std::sin(tilt)},
                       {2 * std::cos(tilt), 2, 2 * std::sin(tilt)},
                       {0, 2, 0}}});
  const auto faces = faces_of(model, choice_within(0, 0));
  const Vec3 up{0, 0, 0.3};
  CHECK(plane_angle(faces[0].frame.normal, faces[1].frame.normal) ==
        doctest::Approx(tilt).epsilon(1e-9));
  CHECK(plane_angle({0, 0, 1}, {0, 0, -1}) == 0);
  CHECK(plane_distance(faces[0], faces[1], up) ==
        doctest::Approx(0.3 + std::sin(tilt)).epsilon(1e-12));
  const auto meets = [&](double angle_rad, double distance_m) {
    return on_plane_of(faces[0], faces[1], up, choice_within(angle_rad, distance_m));
  };
  CHECK(meets(0.0201, 0.321));
  CHECK_FALSE(meets(0.0199, 0.321));
  CHECK_FALSE(meets(0.0201, 0.319));
  const auto flat = region_in(faces[0].frame, faces[1], up);
  REQUIRE(flat.size() == 1);
  CHECK(region_area(flat) == doctest::Approx(4 * std::cos(tilt)).epsilon(1e-4));
}
