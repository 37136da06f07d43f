// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Steps from foot to point: which column tells them, and that they are as long as the distances.
#include "compare/changes/measured_steps.h"

#include <doctest/doctest.h>

#include "base/numbers.h"
#include "unit/compare/changes/epochs.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("measured_steps__come_from_differences_before_nearest_points_before_normals") {
  const Cloud reference = cloud_of({{0, 0, 0}, {5, 5, 5}});
  Comparison made = told({{0, 0, 2}, {5, 5, 6}}, {2, 1});
  const Vec3 along{0.6, 0, 0.8};
  CHECK(MeasuredSteps(made, &reference).of(0, along) == along * 2);
  set_column<double>(made.points, "normal", {0, 1, 0, 1, 0, 0}, 3);
  CHECK(MeasuredSteps(made, &reference).of(0, along) == Vec3{0, 2, 0});
  CHECK(MeasuredSteps(made, &reference).of(1, along) == Vec3{1, 0, 0});
  set_column<uint32_t>(made.points, "nearest", {0, 1});
  CHECK(MeasuredSteps(made, &reference).of(0, along) == Vec3{0, 0, 2});
  CHECK(MeasuredSteps(made, &reference).of(1, along) == Vec3{0, 0, 1});
  set_column<double>(made.points, "difference_x", {-3, 4});
  set_column<double>(made.points, "difference_y", {7, 5});
  set_column<double>(made.points, "difference_z", {8, 6});
  CHECK(MeasuredSteps(made, &reference).of(0, along) == Vec3{-3, 7, 8});
  CHECK(MeasuredSteps(made, nullptr).of(1, along) == Vec3{4, 5, 6});
}

TEST_CASE("measured_steps__fall_back_where_no_nearest_point_can_be_looked_up") {
  const Cloud reference = cloud_of({{0, 0, 0}});
  Comparison made = told({{0, 0, 2}, {0, 0, 3}, {0, 0, 4}}, {2, -3, kNaN});
  set_column<uint32_t>(made.points, "nearest", {0, kNoPoint, kNoPoint});
  const Vec3 up{0, 0, 1}, east{1, 0, 0};
  CHECK(MeasuredSteps(made, &reference).of(0, east) == up * 2);
  CHECK(MeasuredSteps(made, nullptr).of(0, east) == east * 2);  // the cloud is not at hand
  CHECK(MeasuredSteps(made, &reference).of(1, east) == east * -3);
  set_column<double>(made.points, "normal", {0, 1, 0, 0, 1, 0, 0, 1, 0}, 3);
  CHECK(MeasuredSteps(made, &reference).of(1, east) == Vec3{0, -3, 0});
  const Vec3 none = MeasuredSteps(made, &reference).of(2, east);
  for (int axis = 0; axis < 3; ++axis) CHECK(std::isnan(none[axis]));
}

TEST_CASE("measured_steps__of_a_comparison_are_as_long_as_its_distances_whatever_tells_them") {
  RandomStream random(9, 0);
  std::vector<Vec3> was, is;
  add_sheet(was, {0, 0, 0}, {2, 0, 0}, {0, 2, 0.3}, random);
  add_sheet(is, {0, 0, 0.2}, {2, 0, 0.1}, {0, 2, 0}, random);
  const CloudPtr reference = shared_cloud(was);
  DistanceSettings settings;
  settings.local_model = LocalModelKind::kPlane;
  Task task;
  for (const bool differences : {false, true}) {
    // Without differences the foot on the plane is lost: the nearest point's distance is the longer one.
    settings.differences = differences;
    const Comparison made = compare_distance(reference, shared_cloud(is), settings, task);
    const auto distance = made.points.require("distance").values<double>();
    const MeasuredSteps steps(made, reference.get());
    for (uint32_t i = 0; i < is.size(); ++i) {
      const double length = norm(steps.of(i, {0, 0, 1}));
      REQUIRE(length >= distance[i] * (1 - 1e-12));
      if (differences) REQUIRE(length <= distance[i] * (1 + 1e-12));
    }
  }
}
