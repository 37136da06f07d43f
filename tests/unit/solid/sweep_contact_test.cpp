// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/sweep_contact.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/solid/bodies.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Transform at(const Vec3& p) { return frame_of({1, 0, 0, 0}, p); }

}  // namespace

TEST_CASE("least_during__a_ball_passes_a_point_at_its_own_time_and_not_within_a_lesser_limit") {
  const Motion motion(at({0, 0, 0}), at({10, 0, 0}));
  const ConvexPiece ball = ConvexPiece::sphere({0, 0, 0}, 0.5);
  const std::vector<Vec3> point{motion.start({4, 2, 0})};
  SweptContact out;
  REQUIRE(least_during(ball, motion, point, 5, out));
  CHECK(std::fabs(out.contact.value - 1.5) <= kSweepTolerance_m);
  CHECK(out.time == doctest::Approx(0.4).epsilon(0.01).scale(0));
  CHECK_FALSE(least_during(ball, motion, point, 1.4, out));
}

TEST_CASE("least_during__a_rod_that_turns_strikes_what_neither_pose_touches") {
  const double quarter = std::sqrt(0.5);  // of w and z of a turn by 90 degrees about z
  const Motion motion(at({0, 0, 0}), frame_of({quarter, 0, 0, quarter}, {0, 0, 0}));
  const ConvexPiece rod = ConvexPiece::box(Transform(), {4, 0.2, 0.2});
  const Vec3 pole{1.5 * quarter, 1.5 * quarter, 0};
  CHECK(rod.distance(motion.seen_at(motion.start(pole), 0)).value > 0.9);
  CHECK(rod.distance(motion.seen_at(motion.start(pole), 1)).value > 0.9);
  SweptContact out;
  REQUIRE(least_during(rod, motion, std::vector<Vec3>{motion.start(pole)}, 0, out));
  CHECK(std::fabs(out.contact.value + 0.1) <= kSweepTolerance_m);
  CHECK(out.time == doctest::Approx(0.5).epsilon(0.01).scale(0));
}

TEST_CASE("least_during__of_triangles_is_never_above_any_moment_s_contact") {
  RandomStream random(61, 0);
  for (int scene = 0; scene < 20; ++scene) {
    const Body body = any_body(random, scene % 4);
    const Transform from = any_frame(random), to = any_frame(random);
    const Motion motion(from, to);
    std::vector<Vec3> corners;
    for (int c = 0; c < 3; ++c) corners.push_back(motion.start(brute::any_vector(random, 3)));
    SweptContact out;
    REQUIRE(least_during(body.piece, motion, corners, 100, out));
    for (int k = 0; k <= 20; ++k) {
      std::vector<Vec3> now;
      for (const Vec3& c : corners) now.push_back(motion.seen_at(c, k / 20.0));
      CHECK(out.contact.value <= least_distance(body.piece, now).value + kSweepTolerance_m + 2e-9);
    }
    CHECK(out.contact.value == doctest::Approx(body.distance(out.contact.point)).epsilon(1e-6));
  }
}

TEST_CASE("may_come_within__says_no_only_when_no_moment_comes_so_near") {
  RandomStream random(62, 0);
  int refused = 0;
  for (int scene = 0; scene < 200; ++scene) {
    const Body body = any_body(random, scene % 4);
    const Transform from = any_frame(random), to = any_frame(random);
    const Motion motion(from, to);
    const Vec3 centre = motion.start(brute::any_vector(random, 6));
    const double radius = 0.5 * random.uniform();
    double lowest = 0;
    if (may_come_within(body.piece, motion, centre, radius, 0.2, lowest)) continue;
    ++refused;
    for (int k = 0; k <= 50; ++k)
      CHECK(body.distance(motion.seen_at(centre, k / 50.0)) - radius > 0.2);
  }
  CHECK(refused > 20);
}
