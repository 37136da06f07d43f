// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "spatial/voxels/voxel_grid.h"

using namespace jalon;

namespace {

std::vector<double> centroids(const std::vector<double>& xyz, const Vec3& origin, double cell_m,
                              unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  Box3 box;
  for (size_t i = 0; i < xyz.size(); i += 3) box.add({xyz[i], xyz[i + 1], xyz[i + 2]});
  const Buffer<double> out = voxel_centroids(xyz, box, origin, cell_m, task);
  return {out.data(), out.data() + out.size()};
}

// A map from (z, y, x) numbers to sums, in its order.
std::vector<double> means_by_map(const std::vector<double>& xyz, const Vec3& origin,
                                 double cell_m) {
  std::map<std::array<double, 3>, std::array<double, 4>> sums;
  for (size_t i = 0; i < xyz.size(); i += 3) {
    const Vec3 p = Vec3{xyz[i], xyz[i + 1], xyz[i + 2]} - origin;
    auto& sum =
        sums[{std::floor(p.z / cell_m), std::floor(p.y / cell_m), std::floor(p.x / cell_m)}];
    for (int axis = 0; axis < 3; ++axis) sum[static_cast<size_t>(axis)] += p[axis];
    ++sum[3];
  }
  std::vector<double> out;
  for (const auto& [cell, sum] : sums)
    for (int axis = 0; axis < 3; ++axis)
      out.push_back(origin[axis] + sum[static_cast<size_t>(axis)] / sum[3]);
  return out;
}

std::vector<double> uniform(size_t n, double size, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < 3 * n; ++i) xyz.push_back(size * (random.uniform() - 0.5));
  return xyz;
}

}  // namespace

TEST_CASE("voxel_centroids__are_the_means_of_the_cells_in_order_of_their_numbers") {
  const auto xyz = uniform(5000, 10, 1);
  for (const double cell_m : {0.3, 1.0, 7.0, 100.0}) {
    CAPTURE(cell_m);
    CHECK(centroids(xyz, {-8, -8, -8}, cell_m) == means_by_map(xyz, {-8, -8, -8}, cell_m));
    CHECK(centroids(xyz, {0, 0, 0}, cell_m) == means_by_map(xyz, {0, 0, 0}, cell_m));
  }
}

TEST_CASE("voxel_centroids__an_outlier_that_wastes_the_high_bits_changes_nothing_else") {
  auto xyz = uniform(140000, 1, 2);  // one bucket of more points than it may keep
  xyz.insert(xyz.end(), {1e6, 2e6, 3e6});
  const auto one = centroids(xyz, {-4, -4, -4}, 0.25, 1);
  CHECK(one == means_by_map(xyz, {-4, -4, -4}, 0.25));
  CHECK(one == centroids(xyz, {-4, -4, -4}, 0.25, 4));
}

TEST_CASE("voxel_centroids__of_equal_points_is_the_point_and_of_none_nothing") {
  std::vector<double> xyz;
  for (int i = 0; i < 1000; ++i) xyz.insert(xyz.end(), {0.5, -1.25, 8});
  CHECK(centroids(xyz, {0, 0, 0}, 0.1) == std::vector<double>{0.5, -1.25, 8});
  CHECK(centroids({}, {0, 0, 0}, 0.1).empty());
}

TEST_CASE("voxel_centroids__refuse_cells_without_size_and_numbers_of_too_many_bits") {
  const auto status = [](double cell_m) {
    try {
      centroids({0, 0, 0, 1000, 0, 0}, {0, 0, 0}, cell_m);
    } catch (const Error& error) {
      return error.status();
    }
    return Status::kOk;
  };
  CHECK(status(0) == Status::kInvalidArgument);
  CHECK(status(-1) == Status::kInvalidArgument);
  CHECK(status(std::nan("")) == Status::kInvalidArgument);
  CHECK(status(1e-10) == Status::kLimit);  // 1e13 cells, and 2^41 are 2.2e12
  CHECK(status(1e-9) == Status::kOk);
}
