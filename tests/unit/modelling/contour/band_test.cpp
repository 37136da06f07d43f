// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The points that can lie on a contour, and the triangles among them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/random.h"
#include "geometry/polygon2.h"
#include "modelling/contour/band.h"

using namespace jalon;

namespace {

constexpr double kSpacing = 0.1, kCell = 0.25;

/// 6 x 6 m.
std::vector<Vec2> square() {
  RandomStream random(3, 71);
  std::vector<Vec2> out;
  for (int r = 0; r < 60; ++r)
    for (int c = 0; c < 60; ++c)
      out.push_back(Vec2{c + 0.3 * random.uniform(), r + 0.3 * random.uniform()} * kSpacing);
  return out;
}

bool has(const ContourBand& band, const Vec2& p) {
  return std::find(band.points.begin(), band.points.end(), p) != band.points.end();
}

double double_area(const ContourBand& band, const Triangle2& t) {
  return cross(band.points[t[1]] - band.points[t[0]], band.points[t[2]] - band.points[t[0]]);
}

}  // namespace

TEST_CASE("contour_band__holds_what_lies_near_the_border_and_nothing_deep_inside") {
  const auto points = square();
  Task task;
  const ContourBand band = contour_band(points, kCell, kSpacing, {}, task);
  REQUIRE(band.is_inner.size() == band.points.size());
  REQUIRE(band.spacing_m.size() == band.points.size());
  for (const Vec2& p : points) {
    const double depth_m = std::min({p.u, p.v, 6 - p.u, 6 - p.v});
    if (depth_m < 1.5 * kCell) CHECK(has(band, p));
    if (depth_m > 4 * kCell) CHECK(!has(band, p));
  }
  for (size_t i = 0; i < band.points.size(); ++i) {
    const Vec2& p = band.points[i];
    if (std::min({p.u, p.v, 6 - p.u, 6 - p.v}) < 0.5 * kCell) CHECK(band.is_inner[i] == 0);
    CHECK(band.spacing_m[i] == doctest::Approx(kSpacing).epsilon(0.3).scale(0));
  }
}

TEST_CASE(
    "contour_band__leaves_out_strings_strays_and_what_is_foreign_but_asks_for_no_deep_point") {
  auto points = square();
  const size_t own = points.size();
  for (int i = 0; i < 20; ++i) points.push_back({9, 0.1 * i});  // another surface's row
  points.push_back({-5, 3});
  std::set<uint32_t> asked;
  Task task;
  const ContourBand band = contour_band(
      points, kCell, kSpacing,
      [&](uint32_t i) {
        asked.insert(i);
        return points[i].u < 0.1;
      },
      task);
  for (const Vec2& p : band.points) {
    CHECK(p.u >= 0.1);
    CHECK(p.u <= 6.1);
  }
  for (uint32_t i = 0; i < own; ++i) {
    const Vec2& p = points[i];
    if (std::min({p.u, p.v, 6 - p.u, 6 - p.v}) > 4 * kCell) CHECK(asked.count(i) == 0);
  }
  CHECK(!band.points.empty());
}

TEST_CASE("contour_band__all_triangles_fill_the_hull_and_short_ones_have_no_long_edge") {
  Task task;
  ContourBand band;
  RandomStream random(5, 72);
  for (int i = 0; i < 300; ++i) band.points.push_back({random.uniform(), random.uniform()});
  band.is_inner.assign(300, 0);
  band.spacing_m.assign(300, 0.06f);
  const auto all = all_triangles(band, task);
  double area = 0;
  for (const Triangle2& t : all) {
    CHECK(double_area(band, t) > 0);
    area += double_area(band, t) / 2;
  }
  std::vector<Vec2> hull;
  for (const uint32_t i : convex_hull(band.points)) hull.push_back(band.points[i]);
  CHECK(area == doctest::Approx(signed_area(hull)).epsilon(1e-3));
  const auto longest = [&](const Triangle2& t) {
    return std::max({norm(band.points[t[0]] - band.points[t[1]]),
                     norm(band.points[t[1]] - band.points[t[2]]),
                     norm(band.points[t[2]] - band.points[t[0]])});
  };
  const auto kept = short_triangles(band, 0.09, task);
  CHECK(kept.size() ==
        static_cast<size_t>(std::count_if(all.begin(), all.end(),
                                          [&](const Triangle2& t) { return longest(t) <= 0.09; })));
  CHECK(kept.size() < all.size());
  band.is_inner.assign(300, 1);  // those span what was left out
  CHECK(short_triangles(band, 0.09, task).size() == all.size());
  CHECK(alpha_triangles(band, 0.01, 0, task).size() == all.size());
}

TEST_CASE("contour_band__alpha_keeps_small_circles_larger_ones_where_points_are_sparse") {
  Task task;
  ContourBand band;
  band.points = {{0, 0}, {3, 0}, {0, 4}};  // circumradius 2.5
  band.is_inner.assign(3, 0);
  band.spacing_m.assign(3, 1.0f);
  CHECK(alpha_triangles(band, 2.51, 0, task).size() == 1);
  CHECK(alpha_triangles(band, 2.49, 0, task).empty());
  CHECK(alpha_triangles(band, 1.3, 0.5, task).size() == 1);  // twice as far apart as is typical
  CHECK(alpha_triangles(band, 1.2, 0.01, task).empty());     // no more than twice counts
  CHECK(alpha_triangles(band, 2.51, 1.1, task).empty());     // denser than typical
}
