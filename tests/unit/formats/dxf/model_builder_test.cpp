// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/dxf/model_builder.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace jalon;
using namespace jalon::dxf;

namespace {

Loop square(double x, double side, const char* layer = "WALL") {
  Loop loop;
  loop.layer = layer;
  loop.corners = {{x, 0, 0}, {x + side, 0, 0}, {x + side, side, 0}, {x, side, 0}};
  loop.bulges.assign(4, 0);
  loop.normal = {0, 0, 1};
  return loop;
}

}  // namespace

TEST_CASE("dxf_builder__a_loop_is_a_face_of_the_part_of_its_layer_in_metres") {
  ModelBuilder builder(Polygons::kAuto, 0.001);
  builder.add(square(0, 2000));
  builder.add(square(5000, 1000, "Window-Copied"));
  builder.add(square(9000, 1000));
  const Model model = builder.take();
  REQUIRE(model.faces.size() == 3);
  CHECK(model.faces[0].area_m2 == doctest::Approx(4));
  CHECK(model.faces[0].plane.normal == Vec3{0, 0, 1});
  REQUIRE(model.parts.size() == 2);
  CHECK(model.parts[0].part_class == "wall");
  CHECK(model.parts[1].part_class == "window");
  CHECK(model.faces[2].part == 0);
  CHECK(model.sagittas.empty());
}

TEST_CASE("dxf_builder__clockwise_loops_are_turned_and_arcs_keep_their_side") {
  Loop disc;
  disc.layer = "C";
  disc.corners = {{0, 0, 0}, {2, 0, 0}};
  disc.bulges = {-1, -1};  // clockwise
  disc.normal = {0, 0, 1};
  ModelBuilder builder(Polygons::kAuto, 1);
  builder.add(disc);
  Loop half = disc;
  half.bulges = {0, 1};
  builder.add(half);
  const Model model = builder.take();
  REQUIRE(model.faces.size() == 2);
  CHECK(model.faces[0].area_m2 == doctest::Approx(std::numbers::pi));
  CHECK(model.sagittas[0] == doctest::Approx(1));
  CHECK(model.faces[1].area_m2 == doctest::Approx(std::numbers::pi / 2));
}

TEST_CASE("dxf_builder__rings_told_to_be_of_one_face_are_outline_and_holes") {
  ModelBuilder builder(Polygons::kAuto, 1);
  Loop outline = square(0, 10), hole = square(1, 2, "WINDOW");
  for (Vec3& p : hole.corners) p.y += 1;
  outline.told.is_ours = hole.told.is_ours = true;
  outline.told.face = hole.told.face = 7;
  outline.told.number = 2, hole.told.number = 5;
  outline.told.part = {"wall 1", "wall"}, hole.told.part = {"window 1", "window"};
  builder.add(outline);
  builder.add(hole);
  Loop again = outline;  // stands for a door at the foot
  again.told.number = 6;
  again.told.part = {"door 1", "door"};
  builder.add(again);
  Loop side = square(0, 10);  // same number, other plane: a face of its own
  for (Vec3& p : side.corners) p = {p.x, 0, p.y};
  side.normal = {0, -1, 0};
  side.told = outline.told;
  builder.add(side);
  const Model model = builder.take();
  REQUIRE(model.faces.size() == 2);
  CHECK(model.faces[0].id == 7);
  CHECK(model.faces[0].ring_count == 2);
  CHECK(model.faces[0].area_m2 == doctest::Approx(100 - 4));
  REQUIRE(model.parts.size() == 3);
  CHECK(model.parts[model.rings[1].part].name == "window 1");
  CHECK(model.parts[model.rings[1].part].parent == model.faces[0].part);
  CHECK(model.faces[1].ring_count == 1);
}

TEST_CASE("dxf_builder__polygons_are_triangles_or_on_demand_faces") {
  const Patch patch{"M", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}};
  ModelBuilder mesh(Polygons::kAuto, 1), faces(Polygons::kFaces, 1);
  mesh.add(patch);
  faces.add(patch);
  const Model a = mesh.take(), b = faces.take();
  CHECK(a.triangles.size() == 2);
  CHECK(a.vertices.size() == 4);
  CHECK(a.triangle_faces == std::vector<uint32_t>{0, 0});
  CHECK(b.faces.size() == 1);
  CHECK(b.faces[0].area_m2 == doctest::Approx(1));
}

TEST_CASE("dxf_builder__what_bounds_nothing_is_left_out") {
  ModelBuilder builder(Polygons::kAuto, 1);
  Loop line = square(0, 1);
  line.corners[2] = line.corners[1], line.corners[3] = line.corners[0];
  builder.add(line);
  builder.add(Loop{});
  CHECK(builder.take().faces.empty());
}
