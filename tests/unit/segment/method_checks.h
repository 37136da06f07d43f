// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "unit/segment/scenes.h"

// What every method of the segmenter must do.
namespace jalon::test {

/// segment(cloud): the method under test.
template <class F>
void refuses_clouds_without_area(F&& segment) {
  const auto status_of = [&](const std::vector<Vec3>& points) {
    try {
      segment(cloud_of(points));
    } catch (const Error& error) {
      return error.status();
    }
    return Status::kOk;
  };
  CHECK(status_of({}) == Status::kInsufficientData);
  CHECK(status_of({{1, 2, 3}}) == Status::kInsufficientData);
  CHECK(status_of({{1, 2, 3}, {4, 5, 6}}) == Status::kInsufficientData);
  CHECK(status_of(std::vector<Vec3>(1000, Vec3{652000, 6861000, 35})) == Status::kDegenerate);
  std::vector<Vec3> line;
  for (int i = 0; i < 500; ++i) line.push_back({1.0 + 0.5 * i, 2.0 - 0.25 * i, 3.0 + 0.125 * i});
  CHECK(status_of(line) == Status::kDegenerate);
  CHECK(status_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) ==
        Status::kOk);  // a plane, but below min_points
}

/// Six upright strips, each 0.1 m behind the last, which a slanted plane would take at once: one by
/// one, none slanted. segment(cloud, seed).
template <class F>
void takes_staggered_strips_one_by_one(F&& segment) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    Scene scene;
    RandomStream random(seed, 7);
    for (int k = 0; k < 6; ++k)
      scene.rectangle(k + 1, {1.5 * k, 0.10 * k, 0}, {1.5, 0, 0}, {0, 0, 8}, 3000, 0.005, random);
    const Segmentation s = segment(cloud_of(scene.points), seed);
    REQUIRE(s.segments.size() == 6);
    for (int k = 1; k <= 6; ++k) {
      size_t best = 0;
      for (uint32_t label = 1; label <= 6; ++label)
        best = std::max(best, overlap(scene, s, k, label));
      CHECK(best >= 2940);
    }
    for (const Segment& found : s.segments)
      CHECK(std::fabs(found.fit.plane.normal.y) > std::cos(0.5 * std::numbers::pi / 180));
  }
}

/// A plane without noise whose points were stored thrice, one of them over and over, is one segment.
template <class F>
void survives_repeated_points(F&& segment) {
  std::vector<Vec3> points;
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 60; ++k)
      for (int copy = 0; copy < 3; ++copy) points.push_back({0.05 * i, 0.05 * k, 1});
  for (int i = 0; i < 20000; ++i)
    points.push_back({1.5, 1.5, 1});  // one pulse stored over and over
  const Segmentation s = segment(cloud_of(points));
  REQUIRE(s.segments.size() == 1);
  CHECK(s.segments[0].fit.n == points.size());
  CHECK(s.segments[0].fit.sigma < 1e-9);
  CHECK(s.segments[0].orientation == Orientation::kHorizontal);
}

}  // namespace jalon::test
