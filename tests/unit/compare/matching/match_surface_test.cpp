// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What is known of the points of an object, on surfaces whose normals, densities and edges are known.
#include "compare/matching/match_surface.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "unit/compare/standing_things.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("match_surface__finds_the_nearest_point_of_all") {
  Task task;
  const MatchSurface surface(points_of_box({1, 0.6, 0.8}, 400, 3, 0.01), task);
  RandomStream random(9, 9);
  for (int k = 0; k < 200; ++k) {
    const Vec3 q{2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1};
    size_t best = 0;
    for (size_t i = 1; i < surface.size(); ++i)
      if (squared_norm(surface.points()[i] - q) < squared_norm(surface.points()[best] - q))
        best = i;
    REQUIRE(surface.nearest(q).index == best);
    CHECK(std::sqrt(surface.nearest(q).squared_distance) ==
          doctest::Approx(norm(surface.points()[best] - q)).epsilon(1e-12));
  }
}

TEST_CASE("match_surface__knows_normals_and_the_area_that_a_point_stands_for") {
  // 2500 points at random on 1 m2 of a slope: each stands for a disc of 4 cm2.
  constexpr size_t kPoints = 2500;
  const Vec3 slope = normalized({0.3, -0.5, 0.8}), u = normalized(cross(slope, {1, 0, 0})),
             v = cross(slope, u);
  RandomStream random(10, 0);
  std::vector<Vec3> points;
  std::vector<Vec2> places;
  for (size_t i = 0; i < kPoints; ++i) {
    places.push_back({random.uniform(), random.uniform()});
    points.push_back(u * places[i].u + v * places[i].v);
  }
  Task task;
  const MatchSurface surface(points, task);
  double squares = 0, inner = 0;
  Vec3 sum;
  for (size_t i = 0; i < kPoints; ++i) {
    REQUIRE(std::fabs(dot(surface.normal(i), slope)) == doctest::Approx(1).epsilon(1e-9));
    sum += points[i];
    const auto [a, b] = places[i];
    if (std::min({a, b, 1 - a, 1 - b}) < 0.1) continue;  // neighbours all round
    squares += surface.radius(i) * surface.radius(i);
    ++inner;
  }
  // The area to the 11th neighbour has a mean of 11 points' and a scatter of 1 / sqrt(11); 12 points share each: four
  // standard errors of some 1600 points.
  CHECK(std::numbers::pi * squares / inner ==
        doctest::Approx(1.0 / kPoints).epsilon(4 * std::sqrt(12 / (11 * inner))).scale(0));
  CHECK(norm(surface.centroid() - sum / kPoints) < 1e-12);
  for (const Vec3& p : points) CHECK(surface.box().contains(p));
}

TEST_CASE("match_surface__is_flat_away_from_edges") {
  // Two planes meet along the y axis; noise of 1 mm, points 2 cm apart.
  RandomStream random(12, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 1600; ++i) {
    const double across = 0.8 * random.uniform(), y = 0.8 * random.uniform(),
                 noise = 0.001 * random.normal();
    points.push_back(i % 2 == 0 ? Vec3{across, y, noise} : Vec3{noise, y, across});
  }
  Task task;
  const MatchSurface surface(points, task);
  double flat_far = 0, far = 0, flat_near = 0, near = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double from_edge = std::max(points[i].x, points[i].z);
    if (from_edge > 0.1) ++far, flat_far += surface.is_flat(i);
    if (from_edge < 0.01) ++near, flat_near += surface.is_flat(i);
  }
  // Twice the median scatter of 9 degrees of freedom is exceeded by chance once in some thousand.
  CHECK(flat_far > 0.99 * far);
  CHECK(near > 20);
  CHECK(flat_near < 0.1 * near);
}

TEST_CASE("match_surface__samples_evenly_and_takes_few_points_or_none") {
  Task task;
  std::vector<Vec3> row;
  for (int i = 0; i < 100; ++i) row.push_back({0.1 * i, 0, 0});
  const MatchSurface surface(row, task);
  for (const size_t most : {1u, 7u, 33u, 99u, 100u, 1000u}) {
    const auto sample = surface.sample(most);
    CHECK(sample.size() <= most);
    CHECK(2 * sample.size() > std::min<size_t>(most, 100));
    for (size_t i = 2; i < sample.size(); ++i)
      CHECK(norm((sample[i] - sample[i - 1]) - (sample[1] - sample[0])) < 1e-12);
  }
  CHECK(surface.normal(50) == Vec3{});  // a line has no plane
  const MatchSurface one({{1, 2, 3}}, task), none({}, task);
  CHECK(one.nearest({4, 2, 3}).squared_distance == 9);
  CHECK(one.radius(0) == 0);
  CHECK(one.normal(0) == Vec3{});
  CHECK(none.size() == 0);
  CHECK(none.sample(5).empty());
  CHECK(none.sample(0).empty());
  CHECK(surface.sample(0).empty());
}
