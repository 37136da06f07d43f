// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Which way is right and which is up in a plane.
#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "modelling/plane/plane_frame.h"

using namespace jalon;

namespace {

Vec3 direction(RandomStream& random) {
  return normalized(Vec3{random.normal(), random.normal(), random.normal()});
}

}  // namespace

TEST_CASE("plane_frame__is_right_handed_and_lift_undoes_project") {
  RandomStream random(1, 8);
  for (int k = 0; k < 500; ++k) {
    const Plane plane{direction(random), 10 * random.normal()};
    const Vec3 origin = direction(random) * 20;
    const PlaneFrame f = plane_frame(plane, origin, {1, 0, 0});
    CHECK(norm(f.axis_u) == doctest::Approx(1));
    CHECK(norm(f.axis_v) == doctest::Approx(1));
    CHECK(std::fabs(dot(f.axis_u, plane.normal)) < 1e-12);
    CHECK(norm(cross(f.axis_u, f.axis_v) - plane.normal) < 1e-12);
    const Vec2 p{random.normal(), random.normal()};
    CHECK(std::fabs(plane.distance(f.lift(p))) < 1e-12);
    CHECK(norm(f.project(f.lift(p)) - p) < 1e-12);
  }
}

TEST_CASE("plane_frame__of_a_wall_has_level_u_to_the_right_and_v_up") {
  const PlaneFrame f = plane_frame({{0, -1, 0}, 0}, {}, {0, 1, 0});  // seen from -y
  CHECK(norm(f.axis_u - Vec3{1, 0, 0}) < 1e-15);
  CHECK(norm(f.axis_v - Vec3{0, 0, 1}) < 1e-15);
  RandomStream random(2, 8);
  for (int k = 0; k < 100; ++k) {
    const Vec3 n = normalized(Vec3{random.normal(), random.normal(), 0.5 * random.uniform()});
    if (std::fabs(n.z) > 0.9) continue;
    const PlaneFrame slope = plane_frame({n, 1}, {}, {1, 0, 0});
    CHECK(slope.axis_u.z == 0);
    CHECK(slope.axis_v.z > 0);
  }
}

TEST_CASE("plane_frame__of_a_floor_runs_along_the_facade") {
  const Vec3 along = normalized(Vec3{3, 4, 0});
  for (const double up : {1.0, -1.0}) {
    const PlaneFrame f = plane_frame({{0, 0, up}, up * 2}, {1, 1, 0}, along);
    CHECK(norm(f.axis_u - along) < 1e-15);
    CHECK(f.lift({0, 0}).z == doctest::Approx(2));
  }
}

TEST_CASE("plane_frame__whole_metres_that_move_all_change_no_bit_of_the_coordinates") {
  const Vec3 n = normalized(Vec3{0.3, -1, 0.1}), shift{651000, 6861000, 52};
  const PlaneFrame here = plane_frame({n, 0.25}, {1, 2, 3}, {1, 0, 0});
  const PlaneFrame there = plane_frame({n, 0.25 + dot(n, shift)}, Vec3{1, 2, 3} + shift, {1, 0, 0});
  const Vec3 p{1.5, 2.25, 7.125};
  CHECK(here.project(p) == there.project(p + shift));
}
