// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/curves.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"

using namespace jalon;

namespace {

Vec2 on_circle(double angle, double radius) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

TEST_CASE("curves__straight_parts_stay_as_they_are") {
  const LinkagePoint points[] = {{{0, 0}}, {{2, 0}}, {{2, 1}}};
  CHECK(linkage_line(points, true).size() == 3);
  CHECK(linkage_line(points, false).size() == 3);
  CHECK(linkage_line(std::span<const LinkagePoint>(), true).empty());
}

TEST_CASE("curves__points_along_a_circle_give_the_circle") {
  for (const double turn : {1.0, -1.0}) {
    std::vector<LinkagePoint> points;
    for (const double angle : {0.1, 0.5, 0.7, 1.2, 1.5})
      points.push_back({on_circle(turn * angle, 5), true});
    points.front().on_curve = points.back().on_curve = false;
    const std::vector<Vec2> line = linkage_line(points, false);
    CHECK(line.size() > 20);
    for (size_t i = 0; i < line.size(); ++i) {
      CHECK(std::fabs(norm(line[i]) - 5) < 1e-9);
      if (i > 0) CHECK(turn * cross(line[i - 1], line[i]) > 0);
    }
  }
}

TEST_CASE("curves__a_closed_bend_has_the_circles_area") {
  std::vector<LinkagePoint> points;
  for (int i = 0; i < 5; ++i) points.push_back({on_circle(1.2566 * i, 3), true});
  CHECK(signed_area(linkage_line(points, true)) ==
        doctest::Approx(std::acos(-1.0) * 9).epsilon(1e-3));
}

TEST_CASE("curves__a_bend_between_straight_parts_ends_where_it_was_measured") {
  const LinkagePoint points[] = {
      {{-5, 1}}, {{0, 1}}, {{0.70710678, 0.70710678}, true}, {{1, 0}}, {{1, -5}}};
  const std::vector<Vec2> line = linkage_line(points, false);
  CHECK(line.front() == Vec2{-5, 1});
  CHECK(line[1] == Vec2{0, 1});
  CHECK(line.back() == Vec2{1, -5});
  for (size_t i = 2; i + 2 < line.size(); ++i) CHECK(std::fabs(norm(line[i]) - 1) < 1e-6);
}

TEST_CASE("curves__points_of_a_bend_on_one_line_stay_on_it") {
  const LinkagePoint points[] = {{{0, 0}}, {{1, 0}, true}, {{2, 0}, true}, {{3, 0}}};
  for (const Vec2& p : linkage_line(points, false)) CHECK(p.v == 0);
}
