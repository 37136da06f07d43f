// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/voxels/voxel_grid.h"

#include <doctest/doctest.h>

#include <array>
#include <map>

#include "base/error.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Cells = std::map<std::array<int64_t, 3>, std::vector<uint32_t>>;

// Keyed z y x, so that the map's order is the grid's.
Cells cells_of(const std::vector<double>& xyz, const Vec3& origin, double cell) {
  Cells out;
  for (size_t i = 0; i < xyz.size() / 3; ++i) {
    std::array<int64_t, 3> key;
    for (size_t c = 0; c < 3; ++c)
      key[2 - c] =
          static_cast<int64_t>(std::floor((xyz[3 * i + c] - origin[static_cast<int>(c)]) / cell));
    out[key].push_back(static_cast<uint32_t>(i));
  }
  return out;
}

}  // namespace

TEST_CASE("voxel_grid__equals_a_map_of_cells_for_any_cell_size") {
  const auto xyz = street(20000);
  const Vec3 origin{-3, -2, -1};
  for (const double cell :
       {100.0, 1.0, 0.05, 1e-3, 1e-8}) {  // the last: more than 64 bits of cell numbers
    Task task(threads(2));
    const VoxelGrid grid = voxel_grid(xyz, origin, cell, task);
    const Cells expected = cells_of(xyz, origin, cell);
    REQUIRE(grid.size() == expected.size());
    size_t v = 0;
    for (const auto& [key, members] : expected) {
      const std::vector<uint32_t> found(grid.order.data() + grid.first[v],
                                        grid.order.data() + grid.first[v + 1]);
      REQUIRE(found == members);
      Vec3 mean;
      for (const uint32_t i : members) mean += point(xyz, i) / static_cast<double>(members.size());
      const Vec3 centroid{grid.centroids[3 * v], grid.centroids[3 * v + 1],
                          grid.centroids[3 * v + 2]};
      REQUIRE(norm(centroid - mean) < 1e-9);
      ++v;
    }
  }
}

TEST_CASE("voxel_grid__is_the_same_for_any_number_of_threads_and_after_whole_metre_shifts") {
  const auto xyz = street(60000, 2, 0x1p-20);
  auto shifted = xyz;
  for (size_t i = 0; i < xyz.size(); ++i)
    shifted[i] += i % 3 == 0 ? 652000.0 : i % 3 == 1 ? 6861000.0 : 35.0;
  Task one(threads(1)), seven(threads(7));
  const VoxelGrid a = voxel_grid(xyz, {-1, -1, -1}, 0.05, one),
                  b = voxel_grid(shifted, {651999, 6860999, 34}, 0.05, seven);
  REQUIRE(a.size() == b.size());
  CHECK(std::equal(a.first.begin(), a.first.end(), b.first.begin()));
  CHECK(std::equal(a.order.begin(), a.order.end(), b.order.begin()));
}

TEST_CASE("voxel_centroids__are_those_of_the_grid_bit_for_bit") {
  auto xyz = street(300000);
  const Vec3 origin{-3, -2, -1};
  const auto check = [&](double cell) {
    Task one(threads(1)), seven(threads(7));
    const VoxelGrid grid = voxel_grid(xyz, origin, cell, seven);
    for (Task* task : {&one, &seven}) {
      const auto centroids = voxel_centroids(xyz, box_of(xyz), origin, cell, *task);
      REQUIRE(centroids.size() == grid.centroids.size());
      CHECK(std::equal(centroids.begin(), centroids.end(), grid.centroids.begin()));
    }
  };
  for (const double cell : {100.0, 1.0, 0.05, 1e-8}) check(cell);
  xyz.insert(xyz.end(),
             {1e4, 2e4, 3e5});  // now the highest bits of the keys part nothing but the outlier
  for (const double cell : {5.0, 0.05}) check(cell);
  Task task;
  CHECK(voxel_centroids({}, Box3{}, {}, 1, task).empty());
  const std::vector<double> equal{1, 2, 3, 1, 2, 3, 1, 2, 3};
  CHECK(voxel_centroids(equal, box_of(equal), {}, 1e-3, task).size() == 3);
  CHECK_THROWS_AS(voxel_centroids(equal, box_of(equal), {}, 0, task), Error);
  CHECK_THROWS_AS(voxel_centroids(equal, box_of(equal), {}, 1e-13, task), Error);
}

TEST_CASE("voxel_grid__takes_degenerate_input") {
  Task task;
  CHECK(voxel_grid({}, {}, 1, task).size() == 0);
  const std::vector<double> equal{1, 2, 3, 1, 2, 3, 1, 2, 3};
  CHECK(voxel_grid(equal, {}, 1e-3, task).size() == 1);
  CHECK_THROWS_AS(voxel_grid(equal, {}, 0, task), Error);
  CHECK_THROWS_AS(voxel_grid(equal, {}, 1e-13, task), Error);
  CHECK_THROWS_AS(voxel_grid(equal, {}, std::nan(""), task), Error);
}
