// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "compare/landslide/ground_grid.h"
#include "compare/landslide/ground_heights.h"
#include "slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("ground_heights__are_those_of_the_slope_with_their_own_sigma") {
  Task task;
  const CloudPtr cloud = slope_survey(false, 5, 40000);
  LandslideSettings settings;
  settings.cell_m = 0.5;
  const VolumeGrid grid = ground_grid(*cloud, *cloud, settings, task);
  const GroundHeights ground = ground_heights(*cloud, grid, 6, task);
  double squares = 0, n = 0;
  for (size_t cell = 0; cell < grid.cells(); ++cell) {
    if (std::isnan(ground.height[cell])) continue;
    const Vec3 p = grid.place(cell, ground.height[cell]);
    const double error = p.z - slope_ground(p.x, p.y, false);
    squares += error * error / ground.variance[cell];
    n += 1;
  }
  MESSAGE("FIGURE ground heights: ", n, " cells, squares of errors over their variances ",
          squares / n);
  CHECK(n > 0.6 * static_cast<double>(grid.cells()));
  CHECK(squares / n > 0.5);
  CHECK(squares / n < 1.5);
}

TEST_CASE("ground_heights__of_points_in_a_corner_are_not_measured") {
  Task task;
  std::vector<Vec3> points;
  for (int i = 0; i < 20; ++i) points.push_back({0.01 * i, 0.005 * i, 7});
  points.push_back({2.9, 2.9, 7});
  const CloudPtr cloud = cloud_of_points(points);
  LandslideSettings settings;
  settings.cell_m = 1;
  const VolumeGrid grid = ground_grid(*cloud, *cloud, settings, task);
  const GroundHeights ground = ground_heights(*cloud, grid, 6, task);
  CHECK(std::isnan(ground.height[0]));
  CHECK(ground.points[0] == 20);
}
