// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/subsample_cells.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

Cloud tagged(const std::vector<Vec3>& points) {
  Cloud cloud = cloud_of(points);
  std::vector<uint32_t> tags(points.size());
  for (size_t i = 0; i < tags.size(); ++i) tags[i] = static_cast<uint32_t>(i);
  cloud.fields.set(make_column<uint32_t>({"tag", ElementType::kUint32, 1, "", ""},
                                         std::span<const uint32_t>(tags)));
  return cloud;
}

std::vector<uint32_t> tags_of(const Cloud& cloud) {
  const auto tags = cloud.fields.require("tag").values<uint32_t>();
  return {tags.begin(), tags.end()};
}

/// Points by cell of a grid that begins at the origin of the enclosing cube.
using Cells = std::map<std::array<double, 3>, std::vector<uint32_t>>;

Cells cells_of(const std::vector<Vec3>& points, const Vec3& origin, double cell_m) {
  Cells cells;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = points[i] - origin;
    cells[{std::floor(p.x / cell_m), std::floor(p.y / cell_m), std::floor(p.z / cell_m)}].push_back(
        static_cast<uint32_t>(i));
  }
  return cells;
}

uint32_t nearest(const std::vector<Vec3>& points, const std::vector<uint32_t>& members,
                 const Vec3& place) {
  return *std::min_element(members.begin(), members.end(), [&](uint32_t a, uint32_t b) {
    return squared_norm(points[a] - place) < squared_norm(points[b] - place);
  });
}

Vec3 origin_of(const std::vector<Vec3>& points) {
  Box3 box;
  for (const Vec3& p : points) box.add(p);
  return enclosing_cube(box).origin;
}

TEST_CASE("one_per_voxel__keeps_the_point_nearest_to_each_centre_in_the_order_of_the_cloud") {
  const auto points = random_points(1500, 5, 2);
  const Vec3 origin = origin_of(points);
  std::vector<uint32_t> expected;
  for (const auto& [cell, members] : cells_of(points, origin, 0.75))
    expected.push_back(nearest(points, members,
                               origin + Vec3{cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5} * 0.75));
  std::sort(expected.begin(), expected.end());
  Task task;
  const Cloud out = one_per_voxel(tagged(points), 0.75, Keep::kNearest, task);
  CHECK(tags_of(out) == expected);
  for (size_t i = 0; i < out.size(); ++i) REQUIRE(out.point(i) == points[expected[i]]);
}

TEST_CASE("one_per_voxel__centroids_carry_the_fields_of_the_point_nearest_to_them") {
  const auto points = random_points(1500, 5, 3);
  std::map<uint32_t, Vec3> expected;  // tag -> centroid
  for (const auto& [cell, members] : cells_of(points, origin_of(points), 1.5)) {
    Vec3 sum;
    for (const uint32_t i : members) sum += points[i];
    const Vec3 mean = sum / static_cast<double>(members.size());
    expected[nearest(points, members, mean)] = mean;
  }
  Task task;
  const Cloud out = one_per_voxel(tagged(points), 1.5, Keep::kCentroid, task);
  REQUIRE(out.size() == expected.size());
  size_t i = 0;
  for (const auto& [tag, mean] : expected) {
    CHECK(tags_of(out)[i] == tag);
    CHECK(norm(out.point(i++) - mean) < 1e-12);
  }
}

TEST_CASE("one_per_octree_cell__level_0_is_one_point_and_a_budget_takes_the_deepest_level") {
  const auto points = random_points(3000, 8, 4);
  const Cloud cloud = tagged(points);
  Task task;
  const Cloud one = one_per_octree_cell(cloud, 0, 0, Keep::kCentroid, task);
  REQUIRE(one.size() == 1);
  Vec3 sum;
  for (const Vec3& p : points) sum += p;
  CHECK(norm(one.point(0) - sum / 3000.0) < 1e-9);
  const auto counts = cloud.octree(task)->cell_counts(task);
  for (const uint64_t budget : {uint64_t{1}, counts[2], counts[3] - 1, counts[3]}) {
    const size_t kept = one_per_octree_cell(cloud, -1, budget, Keep::kNearest, task).size();
    CHECK(kept <= budget);
    const auto next = std::upper_bound(counts.begin(), counts.end(), budget);
    CHECK(kept == *(next - 1));
  }
}

TEST_CASE("one_per_octree_cell__at_the_deepest_level_shares_a_cloud_of_separate_points") {
  std::vector<Vec3> points;
  for (int i = 0; i < 64; ++i) points.push_back({1.0 * (i % 4), 1.0 * (i / 4 % 4), 1.0 * (i / 16)});
  const Cloud cloud = tagged(points);
  Task task;
  CHECK(one_per_octree_cell(cloud, kMaxLevel, 0, Keep::kNearest, task).xyz_buffer ==
        cloud.xyz_buffer);
  CHECK(one_per_voxel(cloud, 0.5, Keep::kNearest, task).xyz_buffer == cloud.xyz_buffer);
  CHECK(status_of([&] { one_per_voxel(cloud, 0, Keep::kNearest, task); }) ==
        Status::kInvalidArgument);
}

}  // namespace
}  // namespace jalon
