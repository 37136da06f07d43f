// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/triangle_contact.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/solid/bodies.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("least_distance__of_a_point_is_its_distance_with_its_gradient") {
  const ConvexPiece box = ConvexPiece::box(Transform(), {2, 2, 2});
  const std::vector<Vec3> point{{4, 0.5, 0.25}};
  const Contact c = least_distance(box, point);
  CHECK(c.value == doctest::Approx(3));
  CHECK(c.point == point[0]);
  CHECK(c.gradient.x == doctest::Approx(1));
}

TEST_CASE("least_distance__of_a_triangle_lies_inside_it_on_an_edge_or_deep_in_the_piece") {
  const ConvexPiece ball = ConvexPiece::sphere({0, 0, 0}, 1);
  const std::vector<Vec3> above{{-5, -5, 3}, {5, -5, 3}, {0, 9, 3}};
  const Contact c = least_distance(ball, above);
  CHECK(std::fabs(c.value - 2) < 1e-8);
  CHECK(norm(c.point - Vec3{0, 0, 3}) < 1e-3);
  const std::vector<Vec3> edge{{-5, 2, 0}, {5, 2, 0}, {0, 9, 0}};
  CHECK(std::fabs(least_distance(ball, edge).value - 1) < 1e-8);
  const std::vector<Vec3> through{{-5, -5, 0.25}, {5, -5, 0.25}, {0, 9, 0.25}};
  CHECK(std::fabs(least_distance(ball, through).value + 0.75) < 1e-8);
}

TEST_CASE("least_distance__its_plane_lies_below_the_graph_and_over_the_obstacle_within_the_gap") {
  RandomStream random(81, 0);
  for (int i = 0; i < 100; ++i) {
    const Body body = any_body(random, i % 4);
    std::vector<Vec3> corners;
    for (int k = 0; k < 3; ++k) corners.push_back(brute::any_vector(random, 3));
    const Contact c = least_distance(body.piece, corners);
    CHECK(c.gap < 1e-8);
    CHECK(c.value == doctest::Approx(body.distance(c.point)).epsilon(1e-8));
    for (int k = 0; k < 20; ++k) {
      const Vec3 x = brute::any_vector(random, 5);
      CHECK(c.floor + dot(c.slope, x - c.point) <= body.distance(x) + 1e-8);
    }
    for (const Vec3& corner : corners)
      CHECK(c.floor + dot(c.slope, corner - c.point) >= c.value - c.gap - 1e-9);
  }
}
