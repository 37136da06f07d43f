// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/directions.h"

#include <doctest/doctest.h>

using namespace jalon;

TEST_CASE("directions__axes_before_a_facade_are_those_of_who_looks_at_it") {
  const ViewAxes front = axes_before({0, -1, 0});  // seen from -Y, X runs to the right
  CHECK(norm(front.right - Vec3{1, 0, 0}) < 1e-15);
  CHECK(norm(front.up - Vec3{0, 0, 1}) < 1e-15);
  CHECK(norm(front.out - Vec3{0, -1, 0}) < 1e-15);
  const ViewAxes leaning = axes_before(normalized({3, 4, 0.5}));
  CHECK(norm(leaning.out - Vec3{0.6, 0.8, 0}) < 1e-15);
  CHECK(norm(cross(leaning.right, leaning.up) - leaning.out) < 1e-15);
  const ViewAxes plan = axes_before({0, 0, 1});  // from above, as a map
  CHECK(plan.right == Vec3{1, 0, 0});
  CHECK(plan.up == Vec3{0, 1, 0});
  CHECK(plan.out == Vec3{0, 0, 1});
}

TEST_CASE("directions__tell_where_the_whole_of_one_lies_beyond_the_whole_of_the_other") {
  const Box3 window{{2, 1, -0.2}, {3, 2, 0}};
  const auto of = [&](const Box3& other) { return directions(window, other, 0.001); };
  CHECK(of({{4, 1, -0.2}, {5, 2, 0}}) == kRight);
  CHECK(of({{0, 1, -0.2}, {1, 2, 0}}) == kLeft);
  CHECK(of({{2, 3, -0.2}, {3, 4, 0}}) == kAbove);
  CHECK(of({{2, -1, -0.2}, {3, 1, 0}}) == kBelow);  // as it stands on it
  CHECK(of({{2, 1, 0.0}, {3, 2, 0.4}}) == kBefore);
  CHECK(of({{2, 1, -1}, {3, 2, -0.5}}) == kBehind);
  CHECK(of({{5, 5, 1}, {6, 6, 2}}) == (kRight | kAbove | kBefore));
  CHECK(of({{0, 0, -9}, {1, 0.5, -8}}) == (kLeft | kBelow | kBehind));
  CHECK(of({{2.5, 1.5, -0.1}, {9, 9, 9}}) == 0);
  CHECK(of({{3.0005, 1, -0.2}, {4, 2, 0}}) == kRight);
  CHECK(of({{2.9995, 1, -0.2}, {4, 2, 0}}) == kRight);
  CHECK(of({{2.99, 1, -0.2}, {4, 2, 0}}) == 0);
}

TEST_CASE("directions__two_flat_things_in_one_plane_are_neither_before_nor_behind") {
  const Box3 a{{0, 0, 0}, {1, 1, 0}}, b{{2, 0, 0}, {3, 1, 0}};
  CHECK(directions(a, b, 0.001) == kRight);
  CHECK(directions(b, a, 0.001) == kLeft);
  CHECK(directions(a, a, 0.001) == 0);
}
