// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/surface_parts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "base/table_columns.h"
#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kRangeNoise_m = 0.002;
constexpr double kBelow_m = 0.2, kNear_m = 6;  // of the box's upper edge from the scanner
constexpr int kFarRow = 9, kNearRow = 20, kLowRow = 40;

/// A new box before a scanner that hardly looks down on it: its rows of points, by their angles below the horizon. The
/// farthest three rows, metres apart, are regions of their own (4 is the farthest), all else is region 1.
struct BoxAtGrazingRays {
  Comparison comparison;
  Epoch epoch;

  /// lift_m: of the farthest row off the plane of the others.
  explicit BoxAtGrazingRays(double lift_m, const Vec3& shift = {}, double turn_rad = 0,
                            bool has_station = true) {
    constexpr double kStep_rad = 0.0016;
    RandomStream random(5, 0);
    std::vector<Vec3> points;
    for (int column = -50; column <= 50; ++column)
      for (int row = kLowRow; row >= kFarRow; --row) {
        const double around = column * kStep_rad, down = row * kStep_rad;
        const double below_m = kBelow_m - (row == kFarRow ? lift_m : 0);
        const double range =
            std::max(below_m / std::sin(down), kNear_m) + kRangeNoise_m * random.normal();
        const double level = range * std::cos(down);
        points.push_back(shift + Vec3{level * std::sin(around + turn_rad),
                                      level * std::cos(around + turn_rad),
                                      -range * std::sin(down)});
        epoch.regions.labels.push_back(row < kFarRow + 3 ? static_cast<uint32_t>(kFarRow + 4 - row)
                                                         : 1U);
      }
    auto cloud = std::make_shared<Cloud>(cloud_of(points));
    if (has_station) {
      Station station;
      station.has_pose = true;
      for (int k = 0; k < 3; ++k) station.pose.m[static_cast<size_t>(4 * k + 3)] = shift[k];
      station.count = cloud->size();
      cloud->stations = {station};
    }
    comparison.cloud = cloud;
    add_value<double>(comparison.summary, "noise", "m", "", kRangeNoise_m);
    epoch.regions.regions.resize(4);
    epoch.comparison = &comparison;
  }
  BoxAtGrazingRays(const BoxAtGrazingRays&) = delete;
  BoxAtGrazingRays& operator=(const BoxAtGrazingRays&) = delete;
};

std::vector<RegionPair> parts_of(const Epoch& epoch) {
  Task task;
  return parts_of_one_surface(epoch, task);
}
std::vector<RegionPair> parts_of(const BoxAtGrazingRays& box) { return parts_of(box.epoch); }

ChangeRegion region_with_label(const Epoch& epoch, uint32_t label) {
  ChangeRegion out;
  Moments moments;
  for (uint32_t i = 0; i < epoch.regions.labels.size(); ++i) {
    if (epoch.regions.labels[i] != label) continue;
    out.indices.push_back(i);
    moments.add(epoch.cloud().point(i));
  }
  out.centroid = moments.centroid();
  out.axes = symmetric_eigen(moments.covariance());
  return out;
}

/// The two rows of a box's top that a scanner has, and no third: the nearer belongs to a large region (its front) that
/// is no plane, the farther to region 2, with a row of another scanner that crosses it or without.
struct TwoRowsOfTop {
  Comparison comparison;
  Epoch epoch;

  TwoRowsOfTop(bool has_crossing_row, double lift_m) {
    constexpr double kStep_rad = 0.0016, kScatter_m = 0.0003;
    RandomStream random(6, 0);
    std::vector<Vec3> points;
    const auto add = [&](const Vec3& p, uint32_t label) {
      points.push_back(p + Vec3{0, 0, kScatter_m * random.normal()});
      epoch.regions.labels.push_back(label);
    };
    for (int column = -50; column <= 50; ++column) {
      const double around = column * kStep_rad;
      for (const int row : {kFarRow, kFarRow + 1}) {
        const double level = kBelow_m / std::tan(row * kStep_rad);
        add({level * std::sin(around), level * std::cos(around),
             -kBelow_m + (row == kFarRow ? 0 : lift_m)},
            row == kFarRow ? 2 : 1);
      }
      for (int row = kFarRow + 2; row <= kLowRow; ++row)  // its front
        add({kNear_m * std::sin(around), kNear_m * std::cos(around),
             -kNear_m * std::tan(row * kStep_rad)},
            1);
    }
    const size_t seen = points.size();
    for (int k = -20; has_crossing_row && k <= 20; ++k)
      add({0.02 * k, kBelow_m / std::tan(kFarRow * kStep_rad) + 0.05 * k, -kBelow_m}, 2);
    auto cloud = std::make_shared<Cloud>(cloud_of(points));
    Station station;
    station.has_pose = true;
    station.count = seen;
    cloud->stations = {station};
    comparison.cloud = cloud;
    add_value<double>(comparison.summary, "noise", "m", "", kRangeNoise_m);
    epoch.comparison = &comparison;
    for (const uint32_t label : {1U, 2U})
      epoch.regions.regions.push_back(region_with_label(epoch, label));
  }
  TwoRowsOfTop(const TwoRowsOfTop&) = delete;
  TwoRowsOfTop& operator=(const TwoRowsOfTop&) = delete;
};

bool has(const std::vector<RegionPair>& pairs, uint32_t a, uint32_t b) {
  return std::find(pairs.begin(), pairs.end(), RegionPair{a, b}) != pairs.end();
}

}  // namespace

TEST_CASE("surface_parts__rows_of_points_metres_apart_are_one_surface") {
  for (const double turn_rad : {0.0, 0.3, 2.0, 3.1}) {
    const auto pairs = parts_of(BoxAtGrazingRays(0, {652000, 6861000, 40}, turn_rad));
    CHECK(has(pairs, 1, 2));
    CHECK(has(pairs, 2, 3));
    CHECK(has(pairs, 3, 4));
  }
}

TEST_CASE("surface_parts__a_row_off_the_plane_is_none_of_it") {
  const auto pairs = parts_of(BoxAtGrazingRays(0.03));
  CHECK(has(pairs, 1, 2));
  CHECK(has(pairs, 2, 3));
  CHECK_FALSE(has(pairs, 3, 4));
}

TEST_CASE("surface_parts__a_region_that_tells_its_plane_takes_the_next_row_in_it") {
  CHECK(has(parts_of(TwoRowsOfTop(true, 0).epoch), 1, 2));
  CHECK_FALSE(has(parts_of(TwoRowsOfTop(true, 0.03).epoch), 1, 2));
}

TEST_CASE("surface_parts__without_stations_nothing_is_side_by_side") {
  CHECK(parts_of(BoxAtGrazingRays(0, {}, 0, false)).empty());
}
