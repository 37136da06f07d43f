// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/border.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kSpacing_m = 0.1, kMargin_m = 0.025;

// Random points of a 4 x 4 m square, a hole of 1 x 1 m in the middle.
std::vector<Vec2> square_with_hole() {
  RandomStream random(7, 1);
  std::vector<Vec2> points;
  while (points.size() < 1500) {
    const Vec2 p{4 * random.uniform(), 4 * random.uniform()};
    if (std::max(std::abs(p.u - 2), std::abs(p.v - 2)) > 0.5) points.push_back(p);
  }
  return points;
}

double distance_from_border(const Vec2& p) {
  const double outside = std::min({p.u, p.v, 4 - p.u, 4 - p.v});
  const double hole = std::max(std::abs(p.u - 2), std::abs(p.v - 2)) - 0.5;
  return std::min(outside, hole);
}

}  // namespace

TEST_CASE("border_points__finds_the_rim_and_the_hole_and_little_else") {
  Task task;
  const std::vector<Vec2> points = square_with_hole();
  const auto border = border_points(points, kMargin_m, 3 * kSpacing_m, task);
  size_t rim = 0, found = 0, inner = 0, wrong = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double d = distance_from_border(points[i]);
    if (d < kMargin_m / 2) ++rim, found += border[i];
    if (d > 3 * kSpacing_m) ++inner, wrong += border[i];
  }
  CHECK(rim > 20);
  CHECK(static_cast<double>(found) >= 0.9 * static_cast<double>(rim));
  CHECK(static_cast<double>(wrong) <= 0.01 * static_cast<double>(inner));
  MESSAGE("FIGURE border: " << found << " of " << rim << " points on the rim, " << wrong << " of "
                            << inner << " inside");
}

TEST_CASE("border_points__is_the_same_for_any_number_of_threads_and_copes_with_little") {
  const std::vector<Vec2> points = square_with_hole();
  Task one(threads(1)), seven(threads(7));
  CHECK(border_points(points, kMargin_m, 0.3, one) == border_points(points, kMargin_m, 0.3, seven));
  CHECK(border_points({}, kMargin_m, 0.3, one).empty());
  const std::vector<Vec2> same(5, Vec2{1, 1});
  CHECK(border_points(same, kMargin_m, 0.3, one) == std::vector<uint8_t>(5, 1));
}
