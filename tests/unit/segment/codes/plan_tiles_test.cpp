// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/plan_tiles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("plan_tiles__hold_what_a_circle_meets_in_ascending_order") {
  RandomStream random(1, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 5000; ++i)
    points.push_back(
        {734000 + 20 * random.uniform(), 642000 + 7 * random.uniform(), 3 * random.uniform()});
  const Vec3 origin{734000, 642000, 0};
  Task task;
  const PlanTiles tiles(*cloud_of(points), origin, task);
  for (const Vec2 place : {Vec2{0, 0}, Vec2{10.2, 3.3}, Vec2{19.9, 6.9}, Vec2{-0.5, 8}}) {
    const std::vector<uint32_t> found = tiles.points_about(place, 1.3);
    CHECK(std::is_sorted(found.begin(), found.end()));
    CHECK(found.size() < points.size() / 2);
    std::vector<uint32_t> even = found;
    std::erase_if(even, [](uint32_t i) { return i % 2 != 0; });
    CHECK(tiles.points_about(place, 1.3, [](uint32_t i) { return i % 2 == 0; }) == even);
    for (uint32_t i = 0; i < points.size(); ++i)
      if (norm(in_plan(points[i] - origin) - place) < 1.3)
        CHECK(std::binary_search(found.begin(), found.end(), i));
  }
}

TEST_CASE("plan_tiles__a_point_far_off_makes_them_larger_not_many") {
  Task task;
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1e9, -1e9, 0}};
  const PlanTiles tiles(*cloud_of(points), {}, task);
  CHECK(tiles.points_about({0, 0}, 2) == std::vector<uint32_t>{0, 1});
  const std::vector<Vec3> widest{{-1.7e308, 0, 0}, {1.7e308, 0, 0}};
  CHECK(PlanTiles(*cloud_of(widest), {}, task).points_about({0, 0}, 1).size() == 2);
}
