// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/surface_pair.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/solid/cube.h"

#ifdef JALON_WITH_FCL

using namespace jalon;
using namespace jalon::test;

TEST_CASE("clearance_of_surfaces__two_cubes_apart__the_gap_and_the_sides_that_face_it") {
  Task task;
  PairSettings settings;
  settings.margin_m = 0.6;
  const PairClearance c = clearance_of_surfaces(cube_surface({0, 0, 0}, 1, task),
                                                cube_surface({1.5, 0, 0}, 1, task), settings, task);
  CHECK(c.least.distance_m == doctest::Approx(0.5));
  CHECK(norm(c.least.second_point - c.least.first_point) == doctest::Approx(0.5));
  CHECK_FALSE(c.meet);
  CHECK(c.depth_m == 0);
  // All triangles of the first with a corner at x = 1: only the two of the side x = 0 have none.
  CHECK(c.near.size() == 10);
  for (size_t i = 0; i < c.near.size(); ++i) {
    CHECK(c.near[i].first != 8);
    CHECK(c.near[i].first != 9);
    CHECK(c.near[i].distance_m == doctest::Approx(0.5));
    if (i > 0) CHECK(c.near[i - 1].first < c.near[i].first);
  }
}

TEST_CASE("clearance_of_surfaces__overlapping_and_nested_cubes_meet_with_a_depth") {
  Task task;
  const PartSurface cube = cube_surface({0, 0, 0}, 2, task);
  const PairClearance over =
      clearance_of_surfaces(cube, cube_surface({1.75, 0.5, 0.5}, 1, task), {}, task);
  CHECK(over.meet);
  CHECK(over.least.distance_m == 0);
  CHECK(over.depth_m == doctest::Approx(0.25).epsilon(1e-6).scale(0));
  CHECK(norm(over.deepest - over.deepest_foot) == doctest::Approx(0.25).epsilon(1e-6).scale(0));
  // The inner one ends at 1.25 on every axis: 0.75 m under the nearest side.
  const PartSurface inner = cube_surface({0.5, 0.5, 0.5}, 0.75, task);
  const PairClearance nested = clearance_of_surfaces(inner, cube, {}, task),
                      swapped = clearance_of_surfaces(cube, inner, {}, task);
  CHECK(nested.meet);
  CHECK(nested.depth_m == doctest::Approx(swapped.depth_m));
  CHECK(nested.depth_m == doctest::Approx(0.75).epsilon(1e-6).scale(0));
}

TEST_CASE("clearance_of_surfaces__sheets_have_no_depth") {
  Task task;
  const PartSurface flat({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{0, 1, 2}}, task);
  const PartSurface upright({{0.5, 0.5, -1}, {0.5, 0.5, 1}, {0.6, 0.6, 1}}, {{0, 1, 2}}, task);
  const PairClearance c = clearance_of_surfaces(flat, upright, {}, task);
  CHECK(c.meet);
  CHECK(std::isnan(c.depth_m));
}

#endif
