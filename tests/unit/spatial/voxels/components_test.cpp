// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/voxels/components.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <vector>

#include "base/error.h"
#include "base/random.h"

using namespace jalon;

namespace {

Components found(const std::vector<double>& xyz, double cell_m, Connectivity3 connectivity,
                 uint64_t min_points = 1, unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return connected_components(xyz, {0, 0, 0}, cell_m, connectivity, min_points, task);
}

std::vector<double> scattered(size_t n, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < 3 * n; ++i) xyz.push_back(12 * random.uniform() - 6);
  return xyz;
}

// Labels spread from point to point until nothing changes: the smallest index of each component.
std::vector<size_t> spread(const std::vector<double>& xyz, double cell_m, int most_axes) {
  const size_t n = xyz.size() / 3;
  const auto cell = [&](size_t i, size_t axis) {
    return static_cast<int>(std::floor(xyz[3 * i + axis] / cell_m));
  };
  std::vector<size_t> label(n);
  std::iota(label.begin(), label.end(), size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (size_t i = 0; i < n; ++i)
      for (size_t j = 0; j < n; ++j) {
        int axes = 0, farthest = 0;
        for (size_t axis = 0; axis < 3; ++axis) {
          const int apart = std::abs(cell(i, axis) - cell(j, axis));
          axes += apart != 0;
          farthest = std::max(farthest, apart);
        }
        if (farthest > 1 || axes > most_axes || label[j] >= label[i]) continue;
        label[i] = label[j];
        changed = true;
      }
  }
  return label;
}

}  // namespace

TEST_CASE("connected_components__equal_labels_spread_over_neighbour_cells") {
  const auto xyz = scattered(300, 3);
  const Connectivity3 kinds[] = {Connectivity3::k6, Connectivity3::k18, Connectivity3::k26};
  for (int kind = 0; kind < 3; ++kind) {
    const Components components = found(xyz, 1, kinds[kind]);
    const auto truth = spread(xyz, 1, kind + 1);
    std::map<size_t, uint32_t> label_of;  // one to one
    for (size_t i = 0; i < truth.size(); ++i) {
      REQUIRE(components.labels[i] > 0);
      REQUIRE(label_of.emplace(truth[i], components.labels[i]).first->second ==
              components.labels[i]);
    }
    CHECK(label_of.size() == components.count());
  }
}

TEST_CASE("connected_components__are_numbered_by_size_then_first_point_and_small_ones_are_0") {
  // Cells 0, 10, 20, 30 along x with 1, 2, 3, 2 points.
  std::vector<double> xyz;
  for (const double x : {10.5, 20.5, 0.5, 30.5, 20.4, 30.4, 20.3, 10.4})
    xyz.insert(xyz.end(), {x, 0, 0});
  const Components all = found(xyz, 1, Connectivity3::k26);
  CHECK(all.labels == std::vector<uint32_t>{2, 1, 4, 3, 1, 3, 1, 2});
  CHECK(all.point_counts == std::vector<uint64_t>{0, 3, 2, 2, 1});
  const Components large = found(xyz, 1, Connectivity3::k26, 3);
  CHECK(large.labels == std::vector<uint32_t>{0, 1, 0, 0, 1, 0, 1, 0});
  CHECK(large.point_counts == std::vector<uint64_t>{5, 3});
}

TEST_CASE("connected_components__join_points_closer_than_a_cell_and_part_wide_gaps") {
  RandomStream random(8, 0);
  for (int trial = 0; trial < 200; ++trial) {
    const double cell_m = 0.1 + random.uniform();
    Vec3 step{random.normal(), random.normal(), random.normal()};
    step = normalized(step);
    const Vec3 a{100 * random.uniform(), 100 * random.uniform(), 100 * random.uniform()};
    const auto count_at = [&](double distance_m) {
      const Vec3 b = a + step * distance_m;
      return found({a.x, a.y, a.z, b.x, b.y, b.z}, cell_m, Connectivity3::k26).count();
    };
    CHECK(count_at(0.999 * cell_m) == 1);
    CHECK(count_at(2.001 * std::sqrt(3.0) * cell_m) == 2);
  }
}

TEST_CASE("connected_components__take_no_points_any_threads_and_refuse_a_cell_of_nothing") {
  const Components none = found({}, 1, Connectivity3::k6);
  CHECK(none.count() == 0);
  CHECK(none.labels.empty());
  const auto xyz = scattered(40000, 4);
  CHECK(found(xyz, 0.2, Connectivity3::k6, 3, 1).labels ==
        found(xyz, 0.2, Connectivity3::k6, 3, 4).labels);
  for (const double cell_m : {0.0, -1.0, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(found(xyz, cell_m, Connectivity3::k6), Error);
}
