// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/nearest_point.h"

#include <doctest/doctest.h>

#include "unit/solid/brute_force.h"

using namespace jalon;

TEST_CASE("nearest_on_triangle__foot_inside_on_an_edge_and_at_a_corner") {
  const Vec3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  CHECK(norm(nearest_on_triangle({1, 1, 5}, a, b, c) - Vec3{1, 1, 0}) < 1e-14);
  CHECK(norm(nearest_on_triangle({1, -2, 5}, a, b, c) - Vec3{1, 0, 0}) < 1e-14);
  CHECK(norm(nearest_on_triangle({3, 3, -1}, a, b, c) - Vec3{2, 2, 0}) < 1e-14);
  CHECK(norm(nearest_on_triangle({9, -1, 2}, a, b, c) - b) < 1e-14);
}

TEST_CASE("nearest_on_triangle__without_area_is_a_segment_or_a_point") {
  const Vec3 a{0, 0, 0}, b{4, 0, 0}, middle{1, 0, 0};
  CHECK(norm(nearest_on_triangle({3, 2, 0}, a, b, middle) - Vec3{3, 0, 0}) < 1e-14);
  CHECK(norm(nearest_on_triangle({3, 2, 0}, a, middle, b) - Vec3{3, 0, 0}) < 1e-14);
  CHECK(norm(nearest_on_triangle({3, 2, 0}, middle, middle, middle) - middle) < 1e-14);
}

TEST_CASE("nearest_on_triangle__equals_a_search_all_over_it") {
  RandomStream random(41, 0);
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = brute::any_vector(random, 1), b = brute::any_vector(random, 1),
               c = brute::any_vector(random, 1), p = brute::any_vector(random, 2);
    const double searched =
        brute::least_on_triangle([&](const Vec3& q) { return norm(p - q); }, a, b, c);
    CHECK(norm(nearest_on_triangle(p, a, b, c) - p) == doctest::Approx(searched).epsilon(1e-6));
  }
}
