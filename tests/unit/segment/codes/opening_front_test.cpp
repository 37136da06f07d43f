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

}  // namespace

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
