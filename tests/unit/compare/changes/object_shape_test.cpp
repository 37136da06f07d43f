// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Where a change ends: bulges against things put there, and the rims of shadows.
#include "compare/changes/object_shape.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "unit/compare/changes/epochs.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::vector<Vec3> ground_with_bulge(double height_m, uint64_t seed,
                                    double ground_m = kApart_m / 2) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  add_surface(points, 3, 3, random, [&](double s, double t) {
    const double x = 3 * s - 1.5, y = 3 * t - 1.5;
    return Vec3{x, y, ground_m + height_m * std::exp(-(x * x + y * y) / (2 * 0.4 * 0.4))};
  });
  return points;
}

BorderOfChange border_of(const TwoEpochs& epochs) {
  std::vector<uint32_t> all(epochs.after.cloud().size());
  std::iota(all.begin(), all.end(), 0U);
  Task task;
  return border_of_change(epochs.after, epochs.before, all, kApart_m, task);
}

// Rows of 20 points, one a region, each in its own cell of 0.1 m along x; rows are metres apart.
struct Rows {
  Comparison made;
  Epoch epoch;

  explicit Rows(const std::vector<double>& distances) {
    std::vector<Vec3> points;
    std::vector<double> all;
    for (size_t row = 0; row < distances.size(); ++row)
      for (int i = 0; i < 20; ++i) {
        points.push_back({0.05 + 0.1 * i, static_cast<double>(row), 0.05});
        all.push_back(distances[row]);
      }
    made = told(points, all);
    epoch.comparison = &made;
    epoch.regions.changed.assign(points.size(), 1);
    for (size_t row = 0; row < distances.size(); ++row) {
      ChangeRegion& region = epoch.regions.regions.emplace_back();
      region.label = static_cast<uint32_t>(row + 1);
      for (uint32_t i = 0; i < 20; ++i) {
        region.indices.push_back(static_cast<uint32_t>(20 * row + i));
        epoch.regions.labels.push_back(region.label);
      }
    }
  }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  // The first n points of a row get a hidden one in the cell beside theirs.
  void hide_beside(size_t row, int n) {
    Cloud cloud = *made.cloud;
    std::vector<Vec3> points;
    for (size_t i = 0; i < cloud.size(); ++i) points.push_back(cloud.point(i));
    const auto old = made.points.require("status").values<uint8_t>();
    std::vector<uint8_t> statuses(old.begin(), old.end());
    for (int i = 0; i < n; ++i) {
      points.push_back({0.05 + 0.1 * i, static_cast<double>(row), 0.15});
      statuses.push_back(static_cast<uint8_t>(CompareStatus::kHidden));
      epoch.regions.changed.push_back(0);
      epoch.regions.labels.push_back(0);
    }
    made.cloud = shared_cloud(points);
    set_column(made.points, "status", statuses);
  }
};

}  // namespace

TEST_CASE("border_of_change__is_soft_around_a_bulge_and_hard_around_a_box") {
  const TwoEpochs bulge(ground_with_bulge(0, 1), ground_with_bulge(0.4, 2));
  const BorderOfChange soft = border_of(bulge);
  CHECK(soft.points > 50);
  CHECK(soft.soft_share(kApart_m) > 0.9);
  CHECK(soft.is_soft(kApart_m));
  std::vector<Vec3> is = ground_with_bulge(0, 3);
  RandomStream random(4, 0);
  add_box(is, {-0.5, -0.5, kApart_m / 2}, {1, 1, 0.8}, random);
  const TwoEpochs box(ground_with_bulge(0, 1), is);
  const BorderOfChange hard = border_of(box);
  CHECK(hard.points > 50);
  CHECK_FALSE(hard.is_soft(kApart_m));
}

TEST_CASE("border_of_change__is_the_same_wherever_the_ground_lies") {
  // In steps of a fifth of what connects the changed points: at 0 the threshold is a whole multiple of it up.
  size_t fewest = SIZE_MAX, most = 0;
  for (const double ground_m : {-0.02, 0.0, 0.02, 0.04, 0.06, 0.08, 0.1}) {
    CAPTURE(ground_m);
    const TwoEpochs bulge(ground_with_bulge(0, 5, ground_m), ground_with_bulge(0.4, 6, ground_m));
    const BorderOfChange soft = border_of(bulge);
    CHECK(soft.points > 50);
    CHECK(soft.soft_share(kApart_m) > 0.9);
    fewest = std::min(fewest, soft.points);
    most = std::max(most, soft.points);
  }
  CHECK(20 * (most - fewest) <= most);  // the same points each time, but for roundings
}

TEST_CASE("border_of_change__is_soft_by_more_than_half_of_ten_points_at_least") {
  BorderOfChange border;
  border.points = 20;
  border.parallel_m.assign(10, 0.15);
  border.parallel_m.insert(border.parallel_m.end(), 5, 0.1501);
  CHECK(border.soft_share(0.1) == 0.5);  // up to one and a half thresholds
  CHECK_FALSE(border.is_soft(0.1));
  border.parallel_m.push_back(0.05);
  CHECK(border.is_soft(0.1));
  border.points = 9;
  CHECK(border.soft_share(0.1) == 0);
}

TEST_CASE("drop_shadow_rims__takes_what_lies_beside_hidden_points_and_numbers_the_others_anew") {
  // In turn: all but one point beside hidden ones; as many but far off; two points; half of them; none.
  Rows rows({0.15, 0.9, -0.15, -0.2, 0.15});
  rows.hide_beside(0, 19);
  rows.hide_beside(1, 20);
  rows.hide_beside(2, 2);
  rows.hide_beside(3, 9);  // and the cell beside the last
  drop_shadow_rims(rows.epoch, 0.1, 0.1);
  const uint32_t expected[] = {0, 1, 2, 0, 3};
  for (size_t i = 0; i < 100; ++i) REQUIRE(rows.epoch.regions.labels[i] == expected[i / 20]);
  REQUIRE(rows.epoch.regions.regions.size() == 3);
  for (uint32_t r = 0; r < 3; ++r) {
    const ChangeRegion& region = rows.epoch.regions.regions[r];
    CHECK(region.label == r + 1);
    for (const uint32_t i : region.indices) REQUIRE(rows.epoch.regions.labels[i] == r + 1);
  }
}
