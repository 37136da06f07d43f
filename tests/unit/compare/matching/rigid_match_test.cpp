// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Motions that were made, and things that are not the same.
#include "compare/matching/rigid_match.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/rigid_motion.h"
#include "unit/compare/standing_things.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr size_t kPoints = 250;
constexpr double kNoise_m = 0.001;
const Vec3 kBox{0.6, 0.4, 0.5};

RigidMatch match_of(const std::vector<Vec3>& before, const std::vector<Vec3>& after,
                    const MatchSetting& setting) {
  Task task;
  return match_rigidly(MatchSurface(before, task), MatchSurface(after, task), setting, task);
}

MatchSetting standing() {
  MatchSetting setting;
  setting.stands = true;
  return setting;
}

std::vector<Vec3> without(std::vector<Vec3> points, double beyond_x) {
  std::erase_if(points, [&](const Vec3& p) { return p.x > beyond_x; });
  return points;
}

}  // namespace

TEST_CASE("rigid_match__finds_a_shift_and_a_turn_within_its_own_covariance") {
  const Transform truth = motion_about({}, {0, 0, 0.3}, {0.25, -0.1, 0});
  const RigidMatch found =
      match_of(points_of_box(kBox, 350, 1, kNoise_m),
               moved(points_of_box(kBox, 350, 2, kNoise_m), truth), standing());
  REQUIRE(found.found);
  CHECK(found.explained >
        0.9);  // points 6 cm apart: local planes across the box's edges are none of it
  CHECK(found.rms_m > 0.5 * kNoise_m);
  CHECK(found.rms_m < 2 * kNoise_m);
  const Vec3 turned = rotation_vector(found.motion * inverse(truth));
  const Vec3 middle = inverse(found.motion).point({0.25, -0.1, 0.3}),
             off = found.motion.point(middle) - truth.point(middle);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<size_t>(i);
    CHECK(std::fabs(turned[i]) < 5 * std::sqrt(found.covariance[7 * k]));
    CHECK(std::fabs(off[i]) < 5 * std::sqrt(found.covariance[7 * (k + 3)]));
    // Of the 350 points at least 30 flat ones fix a direction: their mean, as much again for the planes that they lie
    // on and twice for the turns: 0.5 of the noise.
    CHECK(std::sqrt(found.covariance[7 * (k + 3)]) < 0.5 * kNoise_m);
  }
  CHECK(norm(found.rotation - rotation_vector(found.motion)) < 1e-12);
  // What the middle of the points went by: near the axis of the turn, the shift.
  CHECK(norm(found.displacement - Vec3{0.25, -0.1, 0}) < 0.02);
}

TEST_CASE("rigid_match__a_small_part_of_a_larger_thing_is_no_match") {
  const auto small = points_of_box({0.3, 0.2, 0.25}, kPoints, 3, kNoise_m),
             large = points_of_box({1.5, 1.2, 1}, kPoints, 4, kNoise_m);
  CHECK(match_of(small, large, standing()).explained < 0.5);
  CHECK(match_of(large, small, standing()).explained < 0.5);
}

TEST_CASE("rigid_match__what_could_not_be_seen_afterwards_does_not_count_against_it") {
  const auto before = points_of_box(kBox, kPoints, 5, kNoise_m),
             again = points_of_box(kBox, kPoints, 6, kNoise_m);
  // The far face, 0.2 of 1.24 m2, is gone: 14 % of the box lie on none of the planes that are left.
  const auto explained = [&](bool told) {
    MatchSetting setting = standing();
    if (told) setting.seen_after = [](const Vec3& p) { return p.x <= 0.25; };
    return match_of(before, without(again, 0.25), setting).explained;
  };
  const double told = explained(true), untold = explained(false);
  CHECK(told > 0.9);
  CHECK(told > untold + 0.07);  // half of what is missing
}

TEST_CASE("rigid_match__of_equal_fits_is_the_smaller_motion") {
  // A square box turned by 40 degrees was turned by -50 as well, and by 130 ...
  const Vec3 square{0.5, 0.5, 0.4}, turn{0, 0, 0.698};
  const Transform truth = motion_about({}, turn, {2, -1, 0});
  const RigidMatch found =
      match_of(points_of_box(square, kPoints, 8, kNoise_m),
               moved(points_of_box(square, kPoints, 9, kNoise_m), truth), standing());
  REQUIRE(found.found);
  CHECK(norm(found.rotation - turn) < 0.02);  // the tolerance of 2 cm at its corners would be 0.06
  CHECK(norm(found.displacement - Vec3{2, -1, 0}) < 0.02);
}

TEST_CASE("rigid_match__needs_two_points_for_each_unknown") {
  const auto points = points_of_box(kBox, kPoints, 7);
  const std::vector<Vec3> few(points.begin(), points.begin() + 11);
  CHECK_FALSE(match_of(few, points, {}).found);
  CHECK_FALSE(match_of(points, few, {}).found);
  CHECK_FALSE(match_of({}, points, {}).found);
  const RigidMatch same = match_of(points, points, {});
  CHECK(same.found);
  CHECK(same.explained == 1);
  CHECK(norm(same.displacement) < 1e-6);
}
