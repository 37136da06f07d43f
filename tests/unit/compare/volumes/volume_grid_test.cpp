// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Cells across a direction and the heights of clouds in them, against loops over all points and planes that are known.
#include "compare/volumes/volume_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

VolumeGrid grid_of_cloud(const Cloud& cloud, const Vec3& direction, double cell_m) {
  Task task;
  const double along[] = {direction.x, direction.y, direction.z};
  const VolumeGrid axes = volume_axes(bounds(cloud, task), bounds(cloud, task), along);
  Box3 box;
  for (size_t i = 0; i < cloud.size(); ++i) box.add(axes.project(cloud.point(i)));
  return grid_over(axes, box, cell_m);
}

CellHeights heights_of(const Cloud& cloud, const VolumeGrid& grid, CellValue value) {
  Task task;
  return cloud_heights(cloud, grid, value, task);
}

}  // namespace

TEST_CASE("volume_grid__has_every_point_in_the_cell_whose_centre_is_nearest") {
  const Cloud cloud = cloud_of(shifted(random_points(500, 7, 1), {652000.25, 6861000.5, -3.75}));
  for (const Vec3& direction : {Vec3{0, 0, 2}, Vec3{1, 0, 0}, Vec3{0.3, -0.5, 0.4}}) {
    const VolumeGrid grid = grid_of_cloud(cloud, direction, 0.4);
    CHECK(norm(cross(grid.u, grid.v) - normalized(direction)) < 1e-12);
    for (int a = 0; a < 3; ++a) CHECK(grid.origin[a] == std::floor(grid.origin[a]));
    for (size_t i = 0; i < cloud.size(); ++i) {
      const Vec3 p = grid.project(cloud.point(i));
      const size_t cell = grid.cell_of(p);
      REQUIRE(cell < grid.cells());
      const Vec3 off = grid.place(cell, p.z) - cloud.point(i);
      // Half a cell either way, and what coordinates of 7 digits leave.
      REQUIRE(std::fabs(dot(off, grid.u)) < 0.2 + 1e-8);
      REQUIRE(std::fabs(dot(off, grid.v)) < 0.2 + 1e-8);
      REQUIRE(std::fabs(dot(off, grid.up)) < 1e-8);
    }
    for (size_t c = 0; c < grid.cells(); ++c)
      REQUIRE(grid.cell_of(grid.project(grid.place(c, 2))) == c);
  }
}

TEST_CASE("volume_grid__refuses_no_direction_and_too_many_cells") {
  const auto axes = [](std::vector<double> direction) {
    return volume_axes({{0, 0, 0}, {1, 1, 1}}, {{0, 0, 0}, {1, 1, 1}}, direction);
  };
  for (const std::vector<double>& wrong :
       {std::vector<double>{0, 0, 0}, {1, 2}, {}, {1, 0, std::nan("")}}) {
    CHECK(status_of([&] { axes(wrong); }) == Status::kInvalidArgument);
    CHECK_THROWS_WITH_AS(axes(wrong), doctest::Contains("direction"), Error);
  }
  const VolumeGrid up = axes({0, 0, 1});
  const Box3 wide{{0, 0, 0}, {5792, 5792, 1}};  // 5793^2 cells of 1 m are just more than 2^25
  CHECK(status_of([&] { grid_over(up, wide, 1); }) == Status::kLimit);
  CHECK_THROWS_WITH_AS(grid_over(up, wide, 1), doctest::Contains("cell_m"), Error);
  CHECK(grid_over(up, {{0, 0, 0}, {5791, 5791, 1}}, 1).cells() == size_t{5792} * 5792);
}

TEST_CASE("cloud_heights__are_means_and_medians_of_each_cell_with_the_variance_of_a_mean") {
  const Cloud cloud = cloud_of(random_points(600, 4, 2));
  const VolumeGrid grid = grid_of_cloud(cloud, {0, 0, 1}, 0.5);
  std::vector<std::vector<double>> members(grid.cells());
  for (size_t i = 0; i < cloud.size(); ++i)
    members[grid.cell_of(grid.project(cloud.point(i)))].push_back(cloud.point(i).z);
  const CellHeights mean = heights_of(cloud, grid, CellValue::kMean),
                    median = heights_of(cloud, grid, CellValue::kMedian);
  for (size_t c = 0; c < grid.cells(); ++c) {
    auto& z = members[c];
    REQUIRE(mean.points[c] == z.size());
    if (z.empty()) {
      CHECK(std::isnan(mean.height[c]));
      CHECK(std::isnan(median.height[c]));
      continue;
    }
    std::sort(z.begin(), z.end());
    const auto n = static_cast<double>(z.size());
    double sum = 0, pairs = 0;
    for (const double a : z) {
      sum += a;
      for (const double b : z) pairs += (a - b) * (a - b);
    }
    REQUIRE(mean.height[c] == doctest::Approx(sum / n).epsilon(1e-12));
    REQUIRE(median.height[c] == (z[(z.size() - 1) / 2] + z[z.size() / 2]) / 2);
    // Half the mean squared difference of two points is their variance.
    if (n > 1)
      REQUIRE(mean.variance[c] == doctest::Approx(pairs / (2 * n * (n - 1)) / n).epsilon(1e-9));
    else REQUIRE(mean.variance[c] == 0);
  }
}

TEST_CASE("cloud_heights__interpolated_lie_on_a_slope_and_close_single_gaps") {
  const auto slope = [](double x, double y) { return 2 + 0.4 * x - 0.25 * y; };
  RandomStream random(101, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 4000; ++i) {
    // Points crowd to the left of each metre.
    const double metre = std::floor(10 * random.uniform()),
                 x = metre + std::pow(random.uniform(), 2), y = 10 * random.uniform();
    const bool gap = (x > 4 && x < 5 && y > 4 && y < 5) || (x > 8 && y > 7);
    if (!gap) points.push_back({x, y, slope(x, y)});
  }
  points.push_back({9.99, 9.99, slope(9.99, 9.99)});  // keeps the grid whole
  const Cloud cloud = cloud_of(points);
  const VolumeGrid grid = grid_of_cloud(cloud, {0, 0, 1}, 1);
  const CellHeights plane = heights_of(cloud, grid, CellValue::kInterpolated),
                    mean = heights_of(cloud, grid, CellValue::kMean);
  double mean_off = 0;
  for (size_t c = 0; c < grid.cells(); ++c) {
    const Vec3 at = grid.place(c, 0);
    const double truth = grid.project({at.x, at.y, slope(at.x, at.y)}).z;  // over the origin
    if (std::isnan(plane.height[c])) {
      CHECK(at.x > 8);  // of the 2 x 3 m no cell but those at its rim has five neighbours
      continue;
    }
    if (at.x < 7.9) REQUIRE(plane.height[c] == doctest::Approx(truth).epsilon(1e-9));
    if (mean.points[c] > 0 && at.x < 7.9)
      mean_off = std::max(mean_off, std::fabs(mean.height[c] - truth));
    if (at.x > 4 && at.x < 5 && at.y > 4 && at.y < 5) CHECK(mean.points[c] == 0);
  }
  CHECK(mean_off > 0.05);  // what it takes out
  // In the corner that is empty a cell with three neighbours has no height, one with five has.
  const auto height_at = [&](double x, double y) {
    return plane.height[grid.cell_of(grid.project({x, y, 0}))];
  };
  CHECK(std::isnan(height_at(8.5, 8.5)));
  CHECK(std::isnan(height_at(9.5, 7.5)));
  CHECK_FALSE(std::isnan(height_at(8.5, 7.5)));
}

TEST_CASE("volume_grid__over_two_far_places_has_the_cells_of_both_and_their_numbers") {
  Task task;
  std::vector<Vec3> points = random_points(2000, 10, 4);
  for (size_t i = 0; i < points.size(); i += 2) points[i] += Vec3{100000.25, 37, 0};
  const Cloud cloud = cloud_of(points);
  const VolumeGrid whole = grid_of_cloud(cloud, {0, 0, 1}, 0.5);
  REQUIRE(whole.cells() > 10'000'000);
  const VolumeGrid grid = without_empty_blocks(whole, cloud, cloud, task);
  CHECK(grid.cells() < 8 * KeptBlocks::kBlock * size_t{whole.rows});
  CHECK(grid.all_cells() == whole.cells());
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 p = grid.project(cloud.point(i));
    const size_t cell = grid.cell_of(p), before = whole.cell_of(p);
    REQUIRE(cell < grid.cells());
    REQUIRE(grid.column_of(cell) == before % whole.columns);
    REQUIRE(grid.row_of(cell) == before / whole.columns);
    REQUIRE(grid.place(cell, p.z) == whole.place(before, p.z));
  }
  // What has a few cells a point stays whole.
  const Cloud near = cloud_of(random_points(2000, 10, 4));
  const VolumeGrid plain = grid_of_cloud(near, {0, 0, 1}, 0.5);
  CHECK(without_empty_blocks(plain, near, near, task).cells() == plain.cells());
}
