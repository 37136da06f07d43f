// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/surface_depth.h"

#include <doctest/doctest.h>

#include "unit/solid/cube.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("depth_in__a_cube_is_how_far_another_reaches_into_it") {
  Task task;
  const PartSurface cube = cube_surface({0, 0, 0}, 2, task),
                    small = cube_surface({1.75, 0.5, 0.5}, 1, task);
  REQUIRE(cube.convex());
  const Depth depth = depth_in(small, cube, 0.001, task);
  CHECK(depth.depth_m == doctest::Approx(0.25).epsilon(1e-9).scale(0));
  CHECK(depth.point.x == doctest::Approx(1.75));
  CHECK(depth.foot.x == doctest::Approx(2));
  CHECK(norm(depth.foot - depth.point) == doctest::Approx(depth.depth_m));
}

TEST_CASE("depth_in__is_none_where_nothing_lies_inside") {
  Task task;
  const PartSurface cube = cube_surface({0, 0, 0}, 2, task);
  CHECK(depth_in(cube_surface({2.5, 0, 0}, 1, task), cube, 0.001, task).depth_m == 0);
  // The surface of a shell around it does not lie in it either.
  CHECK(depth_in(cube_surface({-1, -1, -1}, 4, task), cube, 0.001, task).depth_m == 0);
}

TEST_CASE("depth_in__two_cubes_as_one_surface_finds_the_middle_of_a_sheet_in_the_second") {
  Task task;
  const PartSurface pair = Cubes().add({0, 0, 0}, 1).add({5, 0, 0}, 2).surface(task);
  REQUIRE(pair.is_closed());
  REQUIRE_FALSE(pair.convex());
  // Its corners are outside; the plane x = 6 halves the second cube: 1 m deep in its middle.
  const std::vector<Vec3> corners{{6, -9, -9}, {6, 9, -9}, {6, 0, 19}};
  const PartSurface sheet(corners, {{0, 1, 2}}, task);
  const double tolerance = 0.004;
  const Depth depth = depth_in(sheet, pair, tolerance, task);
  CHECK(depth.depth_m <= 1 + 1e-9);
  CHECK(depth.depth_m >= 1 - tolerance);
  CHECK(depth.point.x == doctest::Approx(6));
}
