// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/polygon2.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"

namespace jalon {
namespace {

const std::vector<Vec2> kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
/// A U open at the top.
const std::vector<Vec2> kU{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};

TEST_CASE("signed_area__orientation_and_map_coordinates") {
  CHECK(signed_area(kSquare) == 4);
  CHECK(signed_area(std::vector<Vec2>(kSquare.rbegin(), kSquare.rend())) == -4);
  CHECK(signed_area(kU) == 7);
  CHECK(perimeter(kU) == 16);
  std::vector<Vec2> far = kU;
  for (Vec2& p : far) p = {p.u + 652000, p.v + 6861000};
  CHECK(signed_area(far) == 7);
  CHECK(signed_area(std::vector<Vec2>{}) == 0);
}

TEST_CASE("contains__even_odd_with_the_border_inside") {
  CHECK(contains(kU, {0.5, 2}));
  CHECK_FALSE(contains(kU, {1.5, 2}));
  CHECK(contains(kU, {1.5, 0.5}));
  CHECK(contains(kU, {1, 2}));           // on a side
  CHECK(contains(kU, {2, 1}));           // on a corner
  CHECK_FALSE(contains(kU, {-0.1, 0}));  // level with a side
  CHECK_FALSE(contains(kU, {3.5, 3}));
  // A self-crossing star: the middle is wound twice, so even-odd leaves it out.
  std::vector<Vec2> star;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * std::numbers::pi * (2 * i) / 5;
    star.push_back({std::sin(a), std::cos(a)});
  }
  CHECK_FALSE(contains(star, {0, 0}));
  CHECK(contains(star, {0, 0.8}));
}

TEST_CASE("contains__random_points_of_a_disc__agrees_with_the_radius") {
  std::vector<Vec2> disc;
  for (int i = 0; i < 360; ++i)
    disc.push_back({std::cos(i * std::numbers::pi / 180), std::sin(i * std::numbers::pi / 180)});
  RandomStream random(1, 0);
  for (int i = 0; i < 5000; ++i) {
    const Vec2 p{3 * random.uniform() - 1.5, 3 * random.uniform() - 1.5};
    if (std::fabs(norm(p) - 1) < 1e-3) continue;
    CHECK(contains(disc, p) == (norm(p) < 1));
  }
}

TEST_CASE("segment_distance__foot_inside_and_beyond_the_ends") {
  CHECK(segment_distance({1, 1}, {0, 0}, {2, 0}) == 1);
  CHECK(segment_distance({5, 4}, {0, 0}, {2, 0}) == 5);
  CHECK(segment_distance({3, 4}, {0, 0}, {0, 0}) == 5);
  CHECK(border_distance(kSquare, {1, 0.5}) == 0.5);
  CHECK(std::isinf(border_distance({}, {0, 0})));
}

TEST_CASE("simplified__dropped_corners_stay_within_the_tolerance") {
  RandomStream random(2, 0);
  std::vector<Vec2> line;
  for (int i = 0; i < 500; ++i)
    line.push_back({0.02 * i, std::sin(0.05 * i) + 0.01 * random.normal()});
  for (const double tolerance : {0.01, 0.05, 0.2}) {
    const auto kept = simplified(line, tolerance, false);
    CHECK(kept.front() == 0);
    CHECK(kept.back() == line.size() - 1);
    CHECK(kept.size() < line.size());
    for (size_t k = 1; k < kept.size(); ++k)
      for (uint32_t i = kept[k - 1]; i <= kept[k]; ++i)
        CHECK(segment_distance(line[i], line[kept[k - 1]], line[kept[k]]) <= tolerance);
  }
}

TEST_CASE("simplified__closed_rectangle_with_many_points__its_four_corners") {
  std::vector<Vec2> outline;
  for (int i = 0; i < 40; ++i) outline.push_back({0.1 * i, 0});
  for (int i = 0; i < 30; ++i) outline.push_back({4, 0.1 * i});
  for (int i = 0; i < 40; ++i) outline.push_back({4 - 0.1 * i, 3});
  for (int i = 0; i < 30; ++i) outline.push_back({0, 3 - 0.1 * i});
  CHECK(simplified(outline, 1e-9, true) == std::vector<uint32_t>{0, 40, 70, 110});
  CHECK(simplified(std::vector<Vec2>{{0, 0}, {1, 1}}, 1, true).size() == 2);
  CHECK(simplified(std::vector<Vec2>{}, 1, false).empty());
  CHECK(simplified(std::vector<Vec2>(9, Vec2{1, 1}), 0.1, true).size() == 1);
}

TEST_CASE("convex_hull__holds_all_points_and_drops_collinear_ones") {
  RandomStream random(3, 0);
  std::vector<Vec2> points{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5}};
  for (int i = 0; i < 1000; ++i) points.push_back({10 * random.uniform(), 10 * random.uniform()});
  CHECK(convex_hull(points) == std::vector<uint32_t>{0, 2, 3, 4});
  CHECK(convex_hull(std::vector<Vec2>{}).empty());
  CHECK(convex_hull(std::vector<Vec2>(4, Vec2{1, 1})) == std::vector<uint32_t>{0});
  CHECK(convex_hull(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 2}, {0.5, 0.5}}) ==
        std::vector<uint32_t>{0, 2});
}

TEST_CASE("is_simple__crossing_touching_and_folded_outlines_are_not") {
  CHECK(is_simple(kU));
  CHECK_FALSE(is_simple(std::vector<Vec2>{{0, 0}, {2, 2}, {2, 0}, {0, 2}}));  // bow tie
  CHECK_FALSE(
      is_simple(std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));  // a corner on a side
  CHECK_FALSE(is_simple(std::vector<Vec2>{{0, 0}, {4, 0}, {2, 0}, {2, 2}}));  // folds back
  CHECK_FALSE(is_simple(std::vector<Vec2>{{0, 0}, {1, 0}}));
  CHECK(segments_meet({0, 0}, {2, 0}, {1, 0}, {1, 5}));
  CHECK_FALSE(segments_meet({0, 0}, {2, 0}, {0, 1}, {2, 1}));
}

}  // namespace
}  // namespace jalon
