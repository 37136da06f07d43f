// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Points of no segment without another one near, against all distances.
#include "modelling/plane/lone_points.h"

#include <doctest/doctest.h>

#include <vector>

#include "base/random.h"
#include "cloud/cloud.h"

using namespace jalon;

TEST_CASE("lone_points__are_those_of_no_segment_with_no_other_point_near") {
  constexpr size_t kPoints = 3000;
  constexpr double kNear_m = 0.3;
  RandomStream random(8, 0);
  Buffer<double> xyz(3 * kPoints);
  for (double& c : xyz) c = 6 * random.uniform();
  const Cloud cloud = make_cloud(std::move(xyz));
  std::vector<uint32_t> labels(kPoints, 0);
  for (size_t i = 0; i < kPoints; i += 3) labels[i] = 7;
  for (const unsigned threads : {1u, 4u}) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    const LonePoints lone(cloud, labels, kNear_m, task);
    size_t count = 0;
    for (size_t i = 0; i < kPoints; ++i) {
      bool has_near = false;
      for (size_t j = 0; j < kPoints && !has_near; ++j)
        has_near = j != i && norm(cloud.point(i) - cloud.point(j)) <= kNear_m;
      REQUIRE(lone.has(i) == (labels[i] == 0 && !has_near));
      count += lone.has(i) ? 1 : 0;
    }
    CHECK(count > 100);
    CHECK(count < kPoints / 2);
  }
}

TEST_CASE("lone_points__a_single_point_is_one") {
  Buffer<double> xyz(3);
  for (double& c : xyz) c = 1;
  Task task;
  const LonePoints lone(make_cloud(std::move(xyz)), std::vector<uint32_t>{0}, 1, task);
  CHECK(lone.has(0));
}
