// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "solid/convex_hull.h"
#include "solid/triangle_contact.h"
#include "unit/solid/bodies.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("convex_piece__equals_the_analytic_distance_and_its_gradient_supports_it") {
  RandomStream random(1, 0);
  double worst = 0, below = 0;
  for (int scene = 0; scene < 400; ++scene) {
    const Body body = any_body(random, scene % 4);
    const Vec3 p = brute::any_vector(random, 3), other = brute::any_vector(random, 3);
    const SignedDistance d = body.piece.distance(p);
    worst = std::max(worst, std::abs(d.value - body.distance(p)));
    below = std::max(below, d.value + dot(d.gradient, other - p) - body.distance(other));
    CHECK(norm(d.gradient) == doctest::Approx(1).epsilon(1e-12));
    CHECK(norm(p - body.piece.centre()) - body.piece.radius_m() <= d.value + 1e-9);
  }
  CHECK(worst < 1e-9);
  CHECK(below < 1e-9);
}

TEST_CASE("least_distance__of_a_triangle_equals_a_search_all_over_it") {
  RandomStream random(2, 0);
  double worst = 0;
  for (int scene = 0; scene < 400; ++scene) {
    const Body body = any_body(random, scene % 4);
    const Vec3 at = brute::any_vector(random, 2);
    const double size = scene % 3 == 0 ? 0.2 : 3;
    std::array<Vec3, 3> t;
    for (Vec3& corner : t) corner = at + brute::any_vector(random, size);
    if (scene % 10 == 0) t[2] = t[0] + (t[1] - t[0]) * 0.3;  // without area
    const Contact contact = least_distance(body.piece, t);
    const double truth = brute::least_on_triangle(body.distance, t[0], t[1], t[2]);
    worst = std::max(worst, std::abs(contact.value - truth));
    CHECK(body.distance(contact.point) == doctest::Approx(contact.value).epsilon(1e-9));
    if (std::abs(contact.value - truth) > 1e-7)
      MESSAGE(scene << " " << contact.value << " " << truth);
  }
  MESSAGE(
      "FIGURE least distance of a triangle from a convex piece, worst of 400 scenes by a dense "
      "search: "
      << worst << " m");
  CHECK(worst < 1e-7);
}

TEST_CASE("convex_hull__keeps_the_corners_alone_and_supports_every_point") {
  RandomStream random(3, 0);
  std::vector<Vec3> points = box_corners({2, 1, 4});
  for (int i = 0; i < 9; ++i) points.push_back({1, -0.5, -2 + 0.5 * i});  // along an edge
  for (int i = 0; i < 50; ++i)
    points.push_back({1, brute::uniform(random, -0.5, 0.5), brute::uniform(random, -2, 2)});
  points.push_back(points[3]);
  const ConvexHull hull = convex_hull(points);
  for (const auto& facet : hull.facets)
    for (const Vec3& p : points) CHECK(dot(facet.normal, p) - facet.offset <= 1e-9);
  double volume = 0;
  for (const auto& f : hull.facets)
    volume += dot(hull.corners[f.corners[0]],
                  cross(hull.corners[f.corners[1]], hull.corners[f.corners[2]])) /
              6;
  CHECK(volume == doctest::Approx(8).epsilon(1e-12));
}

TEST_CASE("convex_hull__of_a_ball_has_euler_s_count_of_facets") {
  RandomStream random(4, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i) {
    Vec3 p;
    do p = brute::any_vector(random, 1);
    while (norm(p) > 1 || norm(p) < 0.1);
    points.push_back(normalized(p));
  }
  const ConvexHull hull = convex_hull(points);
  CHECK(hull.corners.size() == 300);
  CHECK(hull.facets.size() == 2 * 300 - 4);
}

TEST_CASE("convex_hull__refuses_flat_and_few_points") {
  const std::vector<Vec3> flat{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 1}};
  CHECK_THROWS_AS(convex_hull(flat), const Error&);
  CHECK_THROWS_AS(convex_hull(std::span(flat).first(3)), const Error&);
  const std::vector<Vec3> equal(6, Vec3{1, 2, 3});
  CHECK_THROWS_AS(convex_hull(equal), const Error&);
}
