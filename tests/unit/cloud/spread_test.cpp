// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Dimensions that points spread over, of floors of even points, of lines and of heaps.

#include "cloud/spread.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "unit/registration/icp_problems.h"

using namespace jalon;
using namespace jalon::test;

namespace {

PointSpread spread(const std::vector<Vec3>& points) {
  Task task;
  return spread_of(*cloud_of(points).octree(task), 16, task);
}

}  // namespace

TEST_CASE("spread_of__tells_lines_from_even_points_whatever_way_these_are_drawn") {
  CHECK(spread(floor_of_lines(0.02, 60, 60)).in_lines < 0.02);
  CHECK(spread(floor_of_lines(0.4, 30, 300)).in_lines > 0.98);
  RandomStream random(18, 0);
  std::vector<Vec3> drawn;
  for (int i = 0; i < 4000; ++i) drawn.push_back({2 * random.uniform(), 2 * random.uniform(), 0});
  CHECK(spread(drawn).in_lines < 0.05);
}

TEST_CASE("spread_of__measures_extents_and_the_noise_of_a_sheet") {
  RandomStream random(19, 0);
  const PointSpread s =
      spread(noisy_sheet({0, 0, 0}, {0.05, 0, 0}, {0, 0.05, 0}, 60, 60, 0.003, random));
  // 16 points of a disc of 0.05^2 each: its radius is 0.113 m, the root mean square of distances 0.08 m.
  CHECK(s.radius_m == doctest::Approx(0.08).scale(0).epsilon(0.1));
  CHECK(s.length_m == doctest::Approx(0.08 / std::sqrt(2.0)).scale(0).epsilon(0.2));
  CHECK(s.noise_m > 0.0025);  // 64 points about their plane, the lower quartile
  CHECK(s.noise_m < 0.003);
}

TEST_CASE("spread_of__counts_marks_of_no_return_and_leaves_them_out") {
  std::vector<Vec3> points = floor_of_lines(0.02, 60, 60);
  points.insert(points.end(), 1200,
                Vec3{-3.1234567, 7.7654321, 1.0 / 3});  // between steps of the grid
  const PointSpread s = spread(points);
  CHECK(s.in_one_place == doctest::Approx(0.25).scale(0).epsilon(0.1));
  CHECK(s.in_lines < 0.02);
  const PointSpread all = spread(std::vector<Vec3>(50, Vec3{1, 2, 3}));
  CHECK(all.in_one_place == 1);
  CHECK(all.length_m == 0);
}

TEST_CASE("points_in_lines__are_those_of_the_lines_beside_an_even_floor_for_any_threads") {
  std::vector<Vec3> points = floor_of_lines(0.02, 60, 60);
  const size_t even = points.size();
  for (const Vec3& p : floor_of_lines(0.4, 20, 200)) points.push_back(p + Vec3{20, 0, 0});
  const Cloud cloud = cloud_of(points);
  Task task, seven(Task::Hooks{.threads = 7});
  const auto tree = cloud.octree(task);
  const std::vector<bool> in_lines = points_in_lines(*tree, 16, task);
  size_t wrong = 0;
  for (size_t i = 0; i < in_lines.size(); ++i) wrong += in_lines[i] != (tree->order()[i] >= even);
  CHECK(wrong < points.size() / 100);
  CHECK(points_in_lines(*tree, 16, seven) == in_lines);
}
