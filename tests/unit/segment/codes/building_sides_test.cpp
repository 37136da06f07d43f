// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/building_sides.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/segment/codes/coded.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// A building of 20 m by 10 m.
CodedObjects house() {
  return surveyed(
      "1;0;0;3;300.2\n2;20;0;3;300.4\n3;20;10;3;300.4\n4;0;10;3;300.4\n5;0;0;0;300.4\n");
}

}  // namespace

TEST_CASE("building_sides__depth_is_positive_inside_and_negative_outside") {
  const CodedObjects all = house();
  const auto depth = [&](double x, double y) {
    return depth_in_buildings(all, Vec2{x - all.origin.x, y - all.origin.y});
  };
  CHECK(depth(10, 3) == doctest::Approx(3));
  CHECK(depth(10, -2) == doctest::Approx(-2));
  CHECK(depth_in_buildings(surveyed(""), {0, 0}) == -INFINITY);
}

TEST_CASE("building_sides__the_way_out_is_across_the_nearest_wall_and_there_is_none_far_off") {
  const CodedObjects all = house();
  const auto way = [&](double x, double y) {
    return way_out_at_pipe(all, Vec2{x - all.origin.x, y - all.origin.y});
  };
  CHECK(norm(way(10, -0.05) - Vec2{0, -1}) < 1e-9);
  CHECK(norm(way(19.95, 5) - Vec2{1, 0}) < 1e-9);
  CHECK(norm(way(10, -0.2)) == 0);
  CHECK(norm(way_out_at_pipe(surveyed(""), {0, 0})) == 0);
}
