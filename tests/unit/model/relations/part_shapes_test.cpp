// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/part_shapes.h"

#include <doctest/doctest.h>

#include "unit/model/relations/boxes.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("part_shapes__a_wall_holds_its_openings_and_what_stands_above_facades_is_left_out") {
  Model m;
  m.parts = {{"building", "building", kNoParent},
             {"facade 1", "facade", 0},
             {"wall 1", "wall", 1},
             {"window 1.1", "window", 2},
             {"nothing", "element", 1}};
  Face face;
  face.part = 2;
  face.plane = {{0, -1, 0}, 0};
  face.area_m2 = 11;
  m.add_face(face, {upright(0, 0, 4, 3), {{1, 0, 1}, {1, 0, 2}, {2, 0, 2}, {2, 0, 1}}});
  m.rings[1].part = 3;
  Task task;
  const auto shapes = part_shapes(m, {0, 0, 0}, 0.001, task);
  REQUIRE(shapes.size() == 3);
  CHECK(shapes[0].part == 1);
  CHECK(shapes[1].part == 2);
  CHECK(shapes[2].part == 3);
  for (const PartShape& shape : shapes) CHECK(shape.facade == 1);
  CHECK(region_area(shapes[1].region) == doctest::Approx(12));
  CHECK(region_area(shapes[2].region) == doctest::Approx(1));
  CHECK(shapes[2].box.min.x == doctest::Approx(1));
  CHECK(shapes[2].box.max.y == doctest::Approx(2));
}

TEST_CASE("part_shapes__an_arc_is_as_wide_as_its_chords_and_what_is_seen_edge_on_has_no_region") {
  Model m;
  add_flat(m, {upright(0, 0, 2, 1)}, "wall");
  m.sagittas.assign(4, 0);
  m.sagittas[2] = 1;  // a round head over the upper edge
  add_flat(m, {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}}, "ground");
  m.sagittas.resize(m.corners.size(), 0);
  Task task;
  const auto shapes = part_shapes(m, {0, 0, 0}, 0.001, task);
  REQUIRE(shapes.size() == 2);
  CHECK(region_area(shapes[0].region) == doctest::Approx(2 + 1.5708).epsilon(0.002).scale(0));
  CHECK(shapes[0].box.max.y == doctest::Approx(2).epsilon(0.001));
  CHECK(shapes[1].region.empty());
}
