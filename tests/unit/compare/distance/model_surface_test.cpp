// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The surface of a model as triangles: areas of what is there, and where each triangle comes from.
#include "compare/distance/model_surface.h"

#include <doctest/doctest.h>

#include <map>
#include <numbers>

#include "unit/compare/distance/plates.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Corners = std::array<Vec3, 3>;

Corners corners_of(const ModelSurface& surface, size_t t) {
  const auto& [a, b, c] = surface.triangles()[t];
  return {surface.vertices()[a], surface.vertices()[b], surface.vertices()[c]};
}

double area_of(const Corners& t) { return norm(cross(t[1] - t[0], t[2] - t[0])) / 2; }

double whole_area(const ModelSurface& surface) {
  double sum = 0;
  for (size_t t = 0; t < surface.triangles().size(); ++t) sum += area_of(corners_of(surface, t));
  return sum;
}

}  // namespace

TEST_CASE("model_surface__has_faces_but_their_openings_and_triangles_that_stand_for_no_face") {
  const Model model = plates();
  Task task;
  const ModelSurface surface(model, 1e-4, task);
  std::map<std::array<uint32_t, 3>, double> areas;
  for (uint32_t t = 0; t < surface.triangles().size(); ++t) {
    const auto source = surface.source(t);
    const Corners corners = corners_of(surface, t);
    areas[{source.face, source.triangle, source.part}] += area_of(corners);
    if (source.face == 0) REQUIRE(is_on_lying_plate((corners[0] + corners[1] + corners[2]) / 3));
  }
  REQUIRE(areas.size() == 3);  // sums of halves and quarters: exact
  CHECK(areas[{0, kNoFace, 0}] == 10);
  CHECK(areas[{1, kNoFace, 1}] == 5);
  CHECK(areas[{kNoFace, 1, kNoPart}] == 1.5);
}

TEST_CASE("model_surface__takes_arcs_to_the_chord_error_and_keeps_loose_triangles_beside_them") {
  Model model = plates();
  Face face;
  face.part = 1;
  face.plane = {{0, 0, 1}, 20};
  model.add_face(face, {{{-2, 0, 20}, {2, 0, 20}}});
  model.sagittas.assign(model.corners.size(), 0);
  model.sagittas.end()[-1] = model.sagittas.end()[-2] = 2;  // a disc of two half circles
  const double truth = 16.5 + 4 * std::numbers::pi;
  Task task;
  for (const double chord_error_m : {0.01, 0.001}) {
    const ModelSurface surface(model, chord_error_m, task);
    CHECK(whole_area(surface) < truth);
    // No more than the ring that the chords may leave.
    CHECK(whole_area(surface) > truth - 4 * std::numbers::pi * chord_error_m);
    const auto last = static_cast<uint32_t>(surface.triangles().size() - 1);
    CHECK(surface.source(last).triangle == 1);
    CHECK(corners_of(surface, last)[1] == Vec3{3, 0, 7});
  }
}

TEST_CASE("model_surface__of_a_mesh_is_the_mesh_whose_numbers_are_parts_where_all_can_be") {
  Model mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}};
  mesh.triangle_faces = {1, 0, 1};
  Task task;
  const auto parts_of = [&] {
    const ModelSurface surface(mesh, 1e-4, task);
    REQUIRE(surface.triangles().size() == 3);
    std::vector<uint32_t> parts;
    for (uint32_t t = 0; t < 3; ++t) {
      CHECK(surface.source(t).triangle == t);
      CHECK(surface.source(t).face == kNoFace);
      parts.push_back(surface.source(t).part);
    }
    return parts;
  };
  CHECK(parts_of() == std::vector<uint32_t>(3, kNoPart));
  mesh.parts = {Part{"a", "w"}, Part{"b", "w"}};
  CHECK(parts_of() == std::vector<uint32_t>{1, 0, 1});
  mesh.triangle_faces[2] = 2;  // there is no such part
  CHECK(parts_of() == std::vector<uint32_t>(3, kNoPart));
}

TEST_CASE("model_surface__of_nothing_is_refused") {
  Model points;
  points.vertices = {{0, 0, 0}, {1, 0, 0}};
  Task task;
  CHECK(refuses([&] { ModelSurface(points, 1e-4, task); }, Status::kInsufficientData,
                "no faces and no triangles"));
}
