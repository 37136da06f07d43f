// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/delaunay2.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "geometry/polygon2.h"

namespace jalon {
namespace {

using Triangles = std::vector<std::array<uint32_t, 3>>;

std::vector<Vec2> random_points(size_t n, double size, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec2> points(n);
  for (Vec2& p : points) p = {size * random.uniform(), size * random.uniform()};
  return points;
}

double area_of(const std::vector<Vec2>& p, const Triangles& triangles) {
  double sum = 0;
  for (const auto& t : triangles) {
    const double twice = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    sum += twice / 2;
  }
  return sum;
}

double hull_area(const std::vector<Vec2>& points) {
  std::vector<Vec2> hull;
  for (uint32_t i : convex_hull(points)) hull.push_back(points[i]);
  return signed_area(hull);
}

/// Exact on coordinates that are small whole numbers.
bool strictly_inside(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 u = a - d, v = b - d, w = c - d;
  return dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v) > 0;
}

size_t circle_violations(const std::vector<Vec2>& p, const Triangles& triangles) {
  size_t violations = 0;
  for (const auto& t : triangles)
    for (const Vec2& q : p) violations += strictly_inside(p[t[0]], p[t[1]], p[t[2]], q);
  return violations;
}

size_t used_nodes(const Triangles& triangles, size_t n) {
  std::vector<bool> used(n);
  for (const auto& t : triangles)
    for (const uint32_t corner : t) used[corner] = true;
  return static_cast<size_t>(std::count(used.begin(), used.end(), true));
}

/// Edges of one triangle alone.
size_t border_edges(const Triangles& triangles) {
  std::vector<uint64_t> edges;
  for (const auto& t : triangles)
    for (size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.push_back(uint64_t{a} << 32 | b);
    }
  std::sort(edges.begin(), edges.end());
  size_t alone = 0;
  for (size_t i = 0; i < edges.size(); ++i)
    alone +=
        (i == 0 || edges[i - 1] != edges[i]) && (i + 1 == edges.size() || edges[i + 1] != edges[i]);
  return alone;
}

TEST_CASE("delaunay__random_points__no_point_in_any_circle_and_the_hull_is_covered") {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<Vec2> points = random_points(20 + 17 * seed, 1000, seed);
    for (Vec2& p : points) p = {std::floor(p.u), std::floor(p.v)};
    const Triangles triangles = delaunay(points, 1.0);
    CHECK(circle_violations(points, triangles) == 0);
    CHECK(area_of(points, triangles) == doctest::Approx(hull_area(points)).scale(0).epsilon(1e-12));
    for (const auto& t : triangles)
      CHECK(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) > 0);
  }
}

TEST_CASE("delaunay__regular_grid__every_square_is_split_in_two") {
  std::vector<Vec2> points;
  for (int v = 0; v < 30; ++v)
    for (int u = 0; u < 40; ++u) points.push_back({0.1 * u, 0.1 * v});
  const Triangles triangles = delaunay(points);
  CHECK(triangles.size() == 2 * 29 * 39);
  CHECK(area_of(points, triangles) == doctest::Approx(3.9 * 2.9).epsilon(1e-9));
}

TEST_CASE("delaunay__points_on_one_circle__a_fan_without_overlap") {
  // All whole-number solutions of x^2 + y^2 = 5^2 * 13^2 * 17^2: exactly cocircular.
  std::vector<Vec2> points;
  const int r = 5 * 13 * 17;
  for (int x = -r; x <= r; ++x)
    for (int y = -r; y <= r; ++y)
      if (x * x + y * y == r * r) points.push_back({double(x), double(y)});
  REQUIRE(points.size() == 108);
  const Triangles triangles = delaunay(points, 1.0);
  CHECK(triangles.size() == points.size() - 2);
  CHECK(area_of(points, triangles) == doctest::Approx(hull_area(points)).scale(0).epsilon(1e-12));
}

TEST_CASE("delaunay__fewer_than_three_or_collinear_or_equal_points__no_triangles") {
  CHECK(delaunay(std::vector<Vec2>{}).empty());
  CHECK(delaunay(std::vector<Vec2>{{1, 2}}).empty());
  CHECK(delaunay(std::vector<Vec2>{{1, 2}, {3, 4}}).empty());
  CHECK(delaunay(std::vector<Vec2>(50, Vec2{1, 2})).empty());
  std::vector<Vec2> line;
  for (int i = 0; i < 100; ++i) line.push_back({0.5 * i, 0.25 * i});
  CHECK(delaunay(line).empty());
  line.push_back({10, 20});
  CHECK(delaunay(line).size() == 99);
}

TEST_CASE("delaunay__duplicates__the_first_point_of_a_node_takes_part_and_no_other") {
  std::vector<Vec2> points = random_points(200, 10, 5);
  const Triangles alone = delaunay(points);
  const size_t n = points.size();
  for (size_t i = 0; i < n; ++i) points.push_back(points[i]);
  const Triangles doubled = delaunay(points);
  CHECK(doubled == alone);
}

TEST_CASE("delaunay__whole_metre_shift__the_same_triangles") {
  std::vector<Vec2> points = random_points(3000, 20, 6);
  for (Vec2& p : points)
    p = {std::floor(p.u * 0x1p20) * 0x1p-20, std::floor(p.v * 0x1p20) * 0x1p-20};
  const Triangles before = delaunay(points);
  for (Vec2& p : points) p = {p.u + 652000, p.v + 6861000};
  CHECK(delaunay(points) == before);
}

TEST_CASE("delaunay__too_wide_or_not_finite__kLimit") {
  const auto status_of = [](std::vector<Vec2> points) {
    try {
      delaunay(points);
    } catch (const Error& error) {
      return error.status();
    }
    return Status::kOk;
  };
  CHECK(status_of({{0, 0}, {1e9, 0}, {0, 1}}) == Status::kLimit);
  CHECK(status_of({{0, 0}, {std::nan(""), 0}, {0, 1}}) == Status::kLimit);
  CHECK(status_of({{0, 0}, {INFINITY, 0}, {0, 1}}) == Status::kLimit);
}

TEST_CASE("delaunay__many_points_fill_their_hull__figures") {
  // Minutes on a busy machine: as many points as that in the long run only.
  const size_t n = std::getenv("JALON_FULL") != nullptr ? 1000000 : 50000;
  const std::vector<Vec2> points = random_points(n, 100, 7);
  const auto start = std::chrono::steady_clock::now();
  const Triangles triangles = delaunay(points);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  MESSAGE("FIGURE Delaunay of ", n, " points: ", seconds, " s, ", triangles.size(), " triangles");
  // Euler: 2 v - 2 - h triangles for v nodes of which h lie on the hull border (collinear ones included).
  const size_t nodes = used_nodes(triangles, n);
  CHECK(n - nodes < 20);  // a million of 1e12 nodes: half a pair on one node
  CHECK(triangles.size() == 2 * nodes - 2 - border_edges(triangles));
  CHECK(area_of(points, triangles) == doctest::Approx(hull_area(points)).epsilon(1e-6));
}

}  // namespace
}  // namespace jalon
