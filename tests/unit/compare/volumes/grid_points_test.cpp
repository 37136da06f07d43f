// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "cloud/statistics.h"
#include "compare/volumes/grid_points.h"
#include "unit/compare/landslide/slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("grid_points__every_point_is_in_its_cell_in_the_cloud_s_order") {
  const CloudPtr cloud = slope_survey(false, 3, 5000);
  Task task;
  const VolumeGrid axes =
      volume_axes(bounds(*cloud, task), bounds(*cloud, task), std::vector<double>{0, 0, 1});
  Box3 box;
  for (size_t i = 0; i < cloud->size(); ++i) box.add(axes.project(cloud->point(i)));
  const VolumeGrid grid = grid_over(axes, box, 2);
  const GridPoints points(*cloud, grid, task);
  size_t all = 0;
  for (size_t cell = 0; cell < grid.cells(); ++cell) {
    all += points.count(cell);
    points.for_each(cell, [&](const Vec3& p) { CHECK(grid.cell_of(p) == cell); });
  }
  CHECK(all == cloud->size());
}
