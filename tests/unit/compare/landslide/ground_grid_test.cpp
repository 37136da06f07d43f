// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "compare/landslide/ground_grid.h"
#include "slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("ground_grid__counts_upward_on_a_slope_and_across_a_cliff") {
  Task task;
  const VolumeGrid slope =
      ground_grid(*slope_survey(false, 1, 2000), *slope_survey(true, 2, 2000), {}, task);
  CHECK(slope.up.z == 1);
  CHECK(slope.u.x == 1);
  // A wall of 80 degrees that faces -y.
  std::vector<Vec3> points;
  RandomStream random(3, 1);
  for (int i = 0; i < 4000; ++i) {
    const double x = 30 * random.uniform(), z = 20 * random.uniform();
    points.push_back({x, 0.1763 * z, z});
  }
  const CloudPtr wall = cloud_of_points(points);
  const VolumeGrid cliff = ground_grid(*wall, *wall, {}, task);
  CHECK(cliff.up.z == doctest::Approx(0.1736).epsilon(0.02).scale(0));
  CHECK(cliff.up.y < -0.98);
  CHECK(std::abs(cliff.u.z) < 1e-12);
  CHECK(norm(cross(cliff.u, cliff.v) - cliff.up) < 1e-12);
}

TEST_CASE("ground_grid__takes_the_smallest_round_cell_that_holds_enough_points") {
  Task task;
  const CloudPtr thin = slope_survey(false, 1, 3000), dense = slope_survey(true, 2, 60000);
  const double cell_m = ground_grid(*thin, *dense, {}, task).cell_m;
  CHECK(cell_m == 2);  // 2.5 points a square metre: 10 of them
  CHECK(ground_grid(*dense, *dense, {}, task).cell_m == 0.5);
}
