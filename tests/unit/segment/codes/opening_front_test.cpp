// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/opening_front.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

/// A frame 2 m wide that stands 3 cm before the plane at its left and 1 cm less at its right, the reveals at both ends
/// before it, panes behind it.
std::vector<Vec3> frame_and_reveals(uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  const auto front = [](double s) { return 0.03 - 0.005 * s; };
  for (int i = 0; i < 400; ++i) {
    const double s = 2 * random.uniform();
    points.push_back({s, front(s) + 0.002 * random.normal(), random.uniform()});
  }
  for (int i = 0; i < 200; ++i)
    points.push_back(
        {i % 2 == 0 ? 0.0 : 2.0, front(i % 2) + 0.1 * random.uniform(), random.uniform()});
  for (int i = 0; i < 60; ++i) {
    const double s = 2 * random.uniform();
    points.push_back({s, front(s) - 0.02 + 0.002 * random.normal(), random.uniform()});
  }
  for (int i = 0; i < 2000; ++i)  // a target on a pane
    points.push_back(
        {0.5 + 0.1 * random.uniform(), front(0.5) - 0.02, 0.4 + 0.1 * random.uniform()});
  return points;
}

/// A frame 8 cm wide about a pane of 1.2 x 1.0 m `pane_m` behind it that returns `returns` of its pulses, the reveals
/// before it.
std::vector<Vec3> window(uint64_t seed, double pane_m, double returns) {
  constexpr int kPoints = 6000;
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < kPoints; ++i) {
    const Vec3 p{1.2 * random.uniform(), 0.002 * random.normal(), random.uniform()};
    const bool is_pane = p.x > 0.08 && p.x < 1.12 && p.z > 0.08 && p.z < 0.92;
    if (is_pane && random.uniform() > returns) continue;
    points.push_back({p.x, p.y - (is_pane ? pane_m : 0), p.z});
  }
  for (int i = 0; i < kPoints / 6; ++i)
    points.push_back({i % 2 == 0 ? 0.0 : 1.2, 0.1 * random.uniform(), random.uniform()});
  return points;
}

}  // namespace

TEST_CASE("opening_front__is_that_of_the_frame_however_much_the_pane_behind_it_returns") {
  for (uint64_t seed = 1; seed <= 5; ++seed)
    for (const double pane_m : {0.02, 0.03, 0.04})
      for (const double returns : {0.0, 0.3, 1.0}) {
        CAPTURE(pane_m);
        CAPTURE(returns);
        OpeningFront front;
        REQUIRE(find_opening_front(window(seed, pane_m, returns), front));
        CHECK(std::fabs(front.before(0.6)) < 0.0015);
        if (returns > 0) CHECK(std::fabs(front.pane_m - pane_m) < 0.008);
        else CHECK(front.pane_m == 0);
      }
}

TEST_CASE("opening_front__a_blind_far_behind_is_no_pane") {
  OpeningFront front;
  REQUIRE(find_opening_front(window(1, 0.07, 1), front));
  CHECK(std::fabs(front.before(0.6)) < 0.0015);
  CHECK(front.pane_m == 0);
  CHECK(depth_behind(front, 0.03) == 0.03);
  front.pane_m = 0.04;
  CHECK(depth_behind(front, 0.03) > 0.04);
}

TEST_CASE("opening_front__is_that_of_the_frame_and_not_of_reveals_or_panes") {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    OpeningFront front;
    REQUIRE(find_opening_front(frame_and_reveals(seed), front));
    for (const double s : {0.0, 1.0, 2.0})
      CHECK(std::fabs(front.before(s) - (0.03 - 0.005 * s)) < 0.0015);
  }
}

TEST_CASE("opening_front__few_points_have_none") {
  OpeningFront front;
  CHECK(!find_opening_front({}, front));
  std::vector<Vec3> few(1000, Vec3{0, 0.01, 0}), upright;  // one place
  for (int k = 0; k < 20; ++k) upright.push_back({1, 0.01, 0.05 * k + 0.02});
  CHECK(!find_opening_front(few, front));
  REQUIRE(find_opening_front(upright, front));  // at one place: no slope
  CHECK(std::fabs(front.before(1) - 0.01) < 0.005);
}
