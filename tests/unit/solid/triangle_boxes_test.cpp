// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/triangle_boxes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>

#include "base/error.h"
#include "solid/nearest_point.h"
#include "unit/solid/brute_force.h"

using namespace jalon;

namespace {

TriangleBoxes random_soup(uint32_t n, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
  for (uint32_t t = 0; t < n; ++t) {
    const Vec3 at = brute::any_vector(random, 5);
    for (int c = 0; c < 3; ++c) vertices.push_back(at + brute::any_vector(random, 0.5));
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  Task task;
  return {vertices, triangles, task};
}

}  // namespace

TEST_CASE("triangle_boxes__the_nearest_triangle_is_that_of_a_loop_over_all") {
  const TriangleBoxes boxes = random_soup(300, 71);
  RandomStream random(72, 0);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = brute::any_vector(random, 7);
    double best = 1e300;
    uint32_t which = 0;
    for (uint32_t t = 0; t < 300; ++t) {
      const auto c = boxes.corners(t);
      const double d = squared_norm(p - nearest_on_triangle(p, c[0], c[1], c[2]));
      if (d < best) best = d, which = t;
    }
    TriangleBoxes::Nearest out;
    REQUIRE(boxes.nearest(p, 100, out));
    CHECK(out.triangle == which);
    CHECK(out.squared_m2 == doctest::Approx(best).epsilon(1e-12));
    CHECK(squared_norm(p - out.point) == doctest::Approx(best).epsilon(1e-12));
  }
}

TEST_CASE("triangle_boxes__ties_go_to_the_lower_index_and_the_limit_is_closed") {
  const std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Task task;
  const TriangleBoxes boxes(vertices, {{2, 1, 0}, {0, 1, 2}, {1, 2, 0}}, task);
  TriangleBoxes::Nearest out;
  REQUIRE(boxes.nearest({0.25, 0.25, 2}, 2, out));
  CHECK(out.triangle == 0);
  CHECK(out.squared_m2 == 4);
  CHECK_FALSE(boxes.nearest({0.25, 0.25, 2}, 1.999, out));
  CHECK_FALSE(TriangleBoxes({}, {}, task).nearest({0, 0, 0}, 1e9, out));
}

TEST_CASE("triangle_boxes__a_walk_finds_every_triangle_once_inside_balls_that_hold_it") {
  const TriangleBoxes boxes = random_soup(100, 73);
  std::vector<int> found(100);
  const auto all = [](const BoundingBall&, double& key) {
    key = 0;
    return true;
  };
  boxes.walk(all, [&](uint32_t t) { ++found[t]; });
  CHECK(std::count(found.begin(), found.end(), 1) == 100);
  // Boxes whose ball is away from a place are not opened: no triangle there is lost.
  const Vec3 place{1, 1, 1};
  std::vector<int> near(100);
  const auto close = [&](const BoundingBall& ball, double& key) {
    key = norm(ball.centre - place);
    return key <= ball.radius_m + 1;
  };
  boxes.walk(close, [&](uint32_t t) { ++near[t]; });
  for (uint32_t t = 0; t < 100; ++t) {
    const auto c = boxes.corners(t);
    if (norm(place - nearest_on_triangle(place, c[0], c[1], c[2])) <= 1) CHECK(near[t] == 1);
  }
  CHECK(std::count(near.begin(), near.end(), 0) > 0);
}

TEST_CASE("triangle_boxes__a_cancel_ends_the_building_of_a_tree") {
  const std::atomic<bool> cancelled{true};
  Task::Hooks hooks;
  hooks.cancel = &cancelled;
  Task task(hooks);
  CHECK_THROWS_AS(TriangleBoxes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, task), Error);
}
