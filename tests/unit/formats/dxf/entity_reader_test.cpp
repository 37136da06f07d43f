// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Each kind of entity, written by hand.
#include <doctest/doctest.h>

#include "formats/dxf/shapes.h"
#include "unit/formats/dxf/dxf_pairs.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::dxf;
using namespace jalon::test;

namespace {

Shapes shapes_of(const std::string& bytes) {
  const Folder folder;
  spill(folder.file("a.dxf"), bytes);
  const ByteSource source(folder.file("a.dxf"));
  GroupReader groups(source);
  Shapes shapes;
  while (groups.next()) read_entity(groups, shapes);
  return shapes;
}

std::string refusal(const std::string& bytes) {
  const Failure failure = failure_of([&] { shapes_of(bytes); });
  CHECK(failure.status == Status::kFormat);
  return failure.text;
}

}  // namespace

TEST_CASE("dxf_entities__a_polyline_stands_in_the_plane_of_its_extrusion") {
  // Object axes of the normal (0, -1, 0): x along x, y along z.
  const Shapes shapes =
      shapes_of(pairs("0 LWPOLYLINE 8 WALL 90 3 70 1 38 -2 210 0 220 -1 230 0 10 0 20 0 10 4 20 0 "
                      "42 0.5 10 4 20 3"));
  REQUIRE(shapes.loops.size() == 1);
  const Loop& loop = shapes.loops[0];
  CHECK(loop.layer == "WALL");
  REQUIRE(loop.corners.size() == 3);
  CHECK(norm(loop.corners[2] - Vec3{4, 2, 3}) < 1e-12);
  CHECK(loop.bulges == std::vector<double>{0, 0.5, 0});
}

TEST_CASE("dxf_entities__open_lines_are_counted_and_ends_that_meet_are_closed") {
  const Shapes shapes =
      shapes_of(pairs("0 LWPOLYLINE 8 0 70 0 10 0 20 0 10 1 20 0 10 1 20 1") +
                pairs("0 LWPOLYLINE 8 0 70 0 10 0 20 0 10 1 20 0 10 1 20 1 10 0 20 0") +
                pairs("0 LINE 8 0 10 0 20 0 11 1 21 1"));
  REQUIRE(shapes.loops.size() == 1);
  CHECK(shapes.loops[0].corners.size() == 3);
  CHECK(shapes.left_out == std::map<std::string, size_t>{{"LINE", 1}, {"open LWPOLYLINE", 1}});
}

TEST_CASE("dxf_entities__polylines_of_vertices_are_loops_grids_and_polyfaces") {
  const std::string end = pairs("0 SEQEND 8 0");
  const Shapes loop = shapes_of(
      pairs("0 POLYLINE 8 W 66 1 70 9 0 VERTEX 10 0 20 0 30 1 70 32 0 VERTEX 10 1 20 0 30 1 70 "
            "32 0 VERTEX 10 1 20 1 30 2 70 32") +
      end);
  REQUIRE(loop.loops.size() == 1);
  CHECK(loop.loops[0].corners[2] == Vec3{1, 1, 2});
  CHECK(norm(loop.loops[0].normal) == 0);
  const std::string four =
      " 0 VERTEX 10 0 20 0 30 0 70 64 0 VERTEX 10 1 20 0 30 0 70 64 0 VERTEX 10 0 20 1 30 0 70 64 "
      "0 "
      "VERTEX 10 1 20 1 30 5 70 64";
  const Shapes grid = shapes_of(pairs("0 POLYLINE 8 G 66 1 70 16 71 2 72 2" + four) + end);
  REQUIRE(grid.patches.size() == 1);
  CHECK(grid.patches[0].polygons == std::vector<std::vector<uint32_t>>{{0, 2, 3, 1}});
  const std::string faces =
      " 0 VERTEX 10 0 20 0 30 0 70 192 0 VERTEX 10 1 20 0 30 0 70 192 0 VERTEX 10 0 20 1 30 0 70 "
      "192 "
      "0 VERTEX 70 128 71 1 72 -2 73 3";
  const Shapes polyface = shapes_of(pairs("0 POLYLINE 8 P 66 1 70 64 71 3 72 1" + faces) + end);
  REQUIRE(polyface.patches.size() == 1);
  CHECK(polyface.patches[0].polygons == std::vector<std::vector<uint32_t>>{{0, 1, 2}});
  CHECK(has_text(refusal(pairs("0 POLYLINE 8 G 66 1 70 16 71 9 72 9" + four) + end),
                 "a mesh of 9 x 9 corners has 4"));
  CHECK(has_text(
      refusal(pairs("0 POLYLINE 8 P 66 1 70 64" + faces + " 0 VERTEX 70 128 71 1 72 2 73 9") + end),
      "a face names corner 9 of 3"));
  CHECK(has_text(refusal(pairs("0 POLYLINE 8 P 66 1 70 64" + faces)), "has no SEQEND"));
}

TEST_CASE("dxf_entities__faces_solids_circles_and_meshes") {
  const Shapes face =
      shapes_of(pairs("0 3DFACE 8 F 10 0 20 0 30 0 11 1 21 0 31 0 12 1 22 1 32 0 13 1 23 1 33 0"));
  REQUIRE(face.patches.size() == 1);
  CHECK(face.patches[0].polygons[0].size() == 3);  // the fourth corner is the third again
  const Shapes solid = shapes_of(pairs("0 SOLID 8 F 10 0 20 0 11 1 21 0 12 0 22 1 13 1 23 1"));
  REQUIRE(solid.patches.size() == 1);
  CHECK(solid.patches[0].corners[2] == Vec3{1, 1, 0});  // round the square, not across it
  const Shapes circle = shapes_of(pairs("0 CIRCLE 8 C 10 5 20 5 30 1 40 2"));
  REQUIRE(circle.loops.size() == 1);
  CHECK(circle.loops[0].corners[0] == Vec3{3, 5, 1});
  CHECK(circle.loops[0].bulges == std::vector<double>{1, 1});
  const Shapes mesh = shapes_of(pairs(
      "0 MESH 8 M 71 2 91 0 92 3 10 0 20 0 30 0 10 1 20 0 30 0 10 0 20 1 30 0 93 4 90 3 90 0 90 1 "
      "90 2 94 0 95 0"));
  REQUIRE(mesh.patches.size() == 1);
  CHECK(mesh.patches[0].polygons == std::vector<std::vector<uint32_t>>{{0, 1, 2}});
  CHECK(has_text(
      refusal(pairs(
          "0 MESH 8 M 92 3 10 0 20 0 30 0 10 1 20 0 30 0 10 0 20 1 30 0 93 4 90 3 90 0 90 1")),
      "the last face of a mesh is not whole"));
}

TEST_CASE("dxf_entities__an_insert_has_its_place_scale_turn_and_rows") {
  const Shapes shapes =
      shapes_of(pairs("0 INSERT 8 A 2 window 10 1 20 2 30 3 41 2 42 3 50 90 70 4 44 1.5"));
  REQUIRE(shapes.inserts.size() == 1);
  const Insert& insert = shapes.inserts[0];
  CHECK(insert.block == "window");
  CHECK(insert.scale == Vec3{2, 3, 1});
  CHECK(insert.columns == 4);
  CHECK(insert.column_step == 1.5);
  CHECK(insert.rotation_rad == doctest::Approx(1.5707963267948966));
}
