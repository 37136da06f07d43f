// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/motion.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "unit/solid/bodies.h"
#include "unit/solid/status.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("motion__half_way_of_a_quarter_turn_is_an_eighth_and_half_of_the_way") {
  Transform to;
  to.m = {0, -1, 0, 4, 1, 0, 0, 0, 0, 0, 1, 2};  // a quarter turn about z, then (4, 0, 2)
  const Motion motion(Transform(), to);
  const double r = std::sqrt(0.5);
  CHECK(norm(motion.to_world({1, 0, 0}, 0.5) - Vec3{2 + r, r, 1}) < 1e-12);
  CHECK(norm(motion.to_world({1, 0, 0}, 1) - Vec3{4, 1, 2}) < 1e-12);
  CHECK(motion.across_axis({3, 4, 12}) == doctest::Approx(5));
}

TEST_CASE("motion__ends_in_its_poses_follows_slerp_and_is_undone_by_the_obstacle_s_view") {
  RandomStream random(31, 0);
  for (int i = 0; i < 50; ++i) {
    const brute::Quaternion a = brute::any_turn(random, 3),
                            b = brute::product(a, brute::any_turn(random, 3));
    const Vec3 from = brute::any_vector(random, 5), to = brute::any_vector(random, 5);
    const Motion motion(frame_of(a, from), frame_of(b, to));
    const Vec3 p = brute::any_vector(random, 2);
    for (const double t : {0.0, 0.3, 0.5, 1.0}) {
      const Vec3 truth = brute::rotation_of(brute::slerp(a, b, t))(p) + from + (to - from) * t;
      CHECK(norm(motion.to_world(p, t) - truth) < 1e-9);
      CHECK(norm(motion.seen_at(motion.start(truth), t) - p) < 1e-9);
    }
  }
}

TEST_CASE("motion__points_leave_their_chords_by_no_more_than_the_acceleration_allows") {
  RandomStream random(32, 0);
  for (int i = 0; i < 200; ++i) {
    const Transform from = any_frame(random), to = any_frame(random);
    const Motion motion(from, to);
    const Vec3 start = brute::any_vector(random, 3);
    const double t = 0.75 * random.uniform(), h = 0.25 * random.uniform();
    const Vec3 middle = motion.seen_at(start, t + h / 2),
               chord = (motion.seen_at(start, t) + motion.seen_at(start, t + h)) * 0.5;
    CHECK(norm(middle - chord) <= h * h / 8 * motion.acceleration_m(start) + 1e-12);
  }
  CHECK(Motion(Transform(), Transform()).acceleration_m({5, 5, 5}) == 0);
}

TEST_CASE("orthonormal__mends_the_nearly_rigid") {
  Transform bent;
  bent.m[0] = 1 + 1e-7, bent.m[1] = 1e-7;
  const Transform t = orthonormal(bent);
  CHECK(std::fabs(t.determinant() - 1) < 1e-14);
  CHECK(std::fabs(t.m[0] * t.m[1] + t.m[4] * t.m[5] + t.m[8] * t.m[9]) < 1e-14);
}
