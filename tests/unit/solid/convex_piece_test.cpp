// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/convex_piece.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/solid/bodies.h"
#include "unit/solid/status.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("convex_piece__signed_distances_of_a_box_at_a_corner_a_side_and_within") {
  Transform frame;
  frame.m[3] = 10;  // centred on x = 10
  const ConvexPiece box = ConvexPiece::box(frame, {2, 4, 6});
  CHECK(box.kind() == ConvexPiece::Kind::kBox);
  CHECK(box.distance({11 + 2, 2 + 3, 3 + 6}).value == doctest::Approx(7));  // 2, 3, 6 of a corner
  const SignedDistance side = box.distance({15, 1, 0});
  CHECK(side.value == doctest::Approx(4));
  CHECK(side.gradient.x == doctest::Approx(1));
  const SignedDistance within = box.distance({10, 1.75, 0});
  CHECK(within.value == doctest::Approx(-0.25));
  CHECK(within.gradient.y == doctest::Approx(1));
}

TEST_CASE("convex_piece__a_cylinder_has_a_side_a_lid_and_a_rim_and_a_sphere_its_radius") {
  const ConvexPiece cylinder = ConvexPiece::cylinder(Transform(), 1, 4);
  CHECK(cylinder.distance({3, 0, 1}).value == doctest::Approx(2));
  CHECK(cylinder.distance({0.5, 0, 3}).value == doctest::Approx(1));
  CHECK(cylinder.distance({4, 0, 6}).value == doctest::Approx(5));
  CHECK(cylinder.distance({0, 0.75, 0}).value == doctest::Approx(-0.25));
  const ConvexPiece ball = ConvexPiece::sphere({1, 2, 3}, 0.5);
  CHECK(ball.distance({1, 2, 8}).value == doctest::Approx(4.5));
  CHECK(ball.distance({1, 2, 3}).value == doctest::Approx(-0.5));
  CHECK(norm(ball.distance({1, 2, 3}).gradient) == doctest::Approx(1));
}

TEST_CASE("convex_piece__distances_are_convex_and_change_by_at_most_a_metre_a_metre") {
  RandomStream random(11, 0);
  for (int i = 0; i < 400; ++i) {
    const Body body = any_body(random, i % 4);
    const Vec3 a = brute::any_vector(random, 3), b = brute::any_vector(random, 3);
    const double at_a = body.piece.distance(a).value, at_b = body.piece.distance(b).value;
    CHECK(body.piece.distance((a + b) * 0.5).value <= (at_a + at_b) / 2 + 1e-9);
    CHECK(std::fabs(at_a - at_b) <= norm(a - b) + 1e-9);
  }
}

TEST_CASE("convex_piece__a_hull_of_a_box_is_the_box_and_a_flat_one_is_refused") {
  const ConvexPiece box = ConvexPiece::box(Transform(), {1, 2, 3}),
                    hull = ConvexPiece::hull(box_corners({1, 2, 3}));
  RandomStream random(12, 0);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = brute::any_vector(random, 2);
    CHECK(hull.distance(p).value == doctest::Approx(box.distance(p).value).epsilon(1e-8));
  }
  const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  CHECK(status_of([&] { ConvexPiece::hull(flat); }) == Status::kDegenerate);
}
