// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/growing_delaunay.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "geometry/delaunay2.h"
#include "geometry/polygon2.h"

namespace jalon {
namespace {

using Triangle = std::array<uint32_t, 3>;

// Nodes of a grid of whole numbers, so that many lie on one circle where it is small.
std::vector<Vec2> random_nodes(size_t n, uint64_t side, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec2> points(n);
  for (Vec2& p : points)
    p = {static_cast<double>(random.below(side)), static_cast<double>(random.below(side))};
  return points;
}

// From the smallest corner on.
Triangle turned(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

std::set<Triangle> set_of(std::span<const Triangle> triangles) {
  std::set<Triangle> out;
  for (const Triangle& t : triangles) out.insert(turned(t));
  CHECK(out.size() == triangles.size());
  return out;
}

// All triangles, one border edge after the other in a random order.
std::set<Triangle> grown(const std::vector<Vec2>& points, uint32_t centre, uint64_t seed) {
  RandomStream random(seed, 1);
  GrowingDelaunay delaunay;
  delaunay.start(points, 1, centre);
  while (!delaunay.border().empty()) delaunay.grow(random.below(delaunay.border().size()));
  return set_of(delaunay.triangles());
}

TEST_CASE("growing_delaunay__about_one_point_and_all_of_it_are_the_same_as_made_at_once") {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    const auto points = random_nodes(3 + 5 * seed, 1 << 25, seed);
    const auto whole = set_of(delaunay(points, 1));
    for (uint32_t centre = 0; centre < points.size(); centre += 3) {
      std::set<Triangle> about;
      for (const Triangle& t : whole)
        if (std::ranges::count(t, centre) > 0) about.insert(t);
      GrowingDelaunay star;
      star.start(points, 1, centre);
      REQUIRE(set_of(star.triangles()) == about);
      REQUIRE(grown(points, centre, seed) == whole);
    }
  }
}

// A few nodes of a small grid, many doubled: squares and larger polygons on one circle everywhere.
TEST_CASE(
    "growing_delaunay__nodes_on_one_circle_are_split_without_overlap_and_the_same_from_"
    "everywhere") {
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    const auto points = random_nodes(5 + seed % 60, 4 + seed % 5, seed);
    std::vector<Vec2> hull;
    for (const uint32_t i : convex_hull(points)) hull.push_back(points[i]);
    const auto first = grown(points, 0, seed);
    double area = 0;
    for (const Triangle& t : first) {
      const double twice = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
      REQUIRE(twice > 0);
      area += twice / 2;
      for (const uint32_t i : t)
        REQUIRE(std::ranges::find(points, points[i]) - points.begin() ==
                i);  // the first on its node
    }
    REQUIRE(area == signed_area(hull));
    for (uint32_t centre = 1; centre < points.size(); ++centre)
      REQUIRE(grown(points, centre, seed + 1) == first);
  }
}

TEST_CASE(
    "growing_delaunay__equal_or_collinear_points_have_no_triangles_and_wide_ones_are_refused") {
  GrowingDelaunay delaunay;
  std::vector<Vec2> line;
  for (int i = 0; i < 20; ++i) line.push_back({3.0 * i, 2.0 * i});
  for (const auto& points : {std::vector<Vec2>{{1, 2}}, std::vector<Vec2>(9, Vec2{1, 2}), line}) {
    delaunay.start(points, 1, 0);
    CHECK(delaunay.triangles().empty());
    CHECK(delaunay.border().empty());
  }
  for (const double far : {0x1p27, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(delaunay.start(std::vector<Vec2>{{0, 0}, {far, 0}, {0, 1}}, 1, 0), Error);
}

}  // namespace
}  // namespace jalon
