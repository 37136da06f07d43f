// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// First guesses of a motion, of things that were moved in a known way.
#include "compare/matching/match_starts.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "geometry/rigid_motion.h"
#include "unit/compare/standing_things.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kDegree = 0.017453292519943295;

std::vector<Vec3> corners_of(const Vec3& half, const Transform& place) {
  std::vector<Vec3> out;
  for (int i = 0; i < 8; ++i)
    out.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
  return moved(out, place);
}

/// How far the best start leaves points from where they truly went.
double left_by_best(const std::vector<Transform>& starts, const Transform& truth,
                    const std::vector<Vec3>& points) {
  double best = std::numeric_limits<double>::infinity();
  for (const Transform& start : starts) {
    double worst = 0;
    for (const Vec3& p : points) worst = std::max(worst, norm(start.point(p) - truth.point(p)));
    best = std::min(best, worst);
  }
  return best;
}

}  // namespace

TEST_CASE("standing_box__lies_around_a_turned_box_as_tight_as_its_steps_allow") {
  const Vec3 half{1, 0.5, 0.3};
  for (const Vec3& up : {Vec3{0, 0, 1}, normalized({0.2, -0.3, 0.9}), Vec3{1, 0, 0}}) {
    const Vec3 axis = cross({0, 0, 1}, up);
    const Transform upright =
        norm(axis) > 0 ? rotation_by(normalized(axis) * std::acos(up.z)) : Transform{};
    for (const double degrees : {0.0, 30.0, 31.0, 77.3}) {
      const Transform place = motion_about({}, up * (degrees * kDegree), {3, 4, 5}) * upright;
      const auto corners = corners_of(half, place);
      const StandingBox box = standing_box(corners, up);
      CHECK(norm(cross(box.along, box.across) - box.up) < 1e-12);
      CHECK(norm(box.centre - Vec3{3, 4, 5}) < 1e-12);
      CHECK(box.half[2] == doctest::Approx(0.3).epsilon(1e-12).scale(0));
      // Tried every 2 degrees: at most one degree off.
      const double s = std::sin(kDegree);
      CHECK(box.half[0] * box.half[1] >= 0.5 - 1e-12);
      CHECK(box.half[0] * box.half[1] <= (1 + 0.5 * s) * (0.5 + s));
      for (const Vec3& p : corners) CHECK(box.contains(p, 1e-12));
    }
  }
}

TEST_CASE("standing_box__contains_what_lies_within_its_margin_on_every_side") {
  const StandingBox box = standing_box(corners_of({1, 0.5, 0.3}, Transform{}), {0, 0, 1});
  for (const Vec3& out :
       {Vec3{1, 0, 0}, {-1, 0, 0}, {0, 0.5, 0}, {0, -0.5, 0}, {0, 0, 0.3}, {0, 0, -0.3}}) {
    const Vec3 beyond = out + normalized(out) * 0.1;
    CHECK(box.contains(out * 0.99, 0));
    CHECK_FALSE(box.contains(beyond, 0.09));
    CHECK(box.contains(beyond, 0.11));
  }
}

TEST_CASE("match_starts__hold_the_turn_about_up_of_what_stands") {
  Task task;
  const auto points = points_of_box({0.9, 0.5, 1.2}, 300, 1);
  const MatchSurface before(points, task);
  MatchSetting setting;
  setting.stands = true;
  for (const double degrees : {0.0, 60.0, 134.0, -98.0}) {
    const Transform truth = motion_about({}, Vec3{0, 0, 1} * (degrees * kDegree), {2, -1, 0});
    const MatchSurface after(moved(points, truth), task);
    const auto starts = match_starts(before, after, setting);
    // Whole steps of the box: it turns with the points.
    CHECK(left_by_best(starts, truth, points) < 1e-9);
    CHECK(starts[0].m == Transform{}.m);
    CHECK(norm(starts[1].point(before.centroid()) - after.centroid()) < 1e-12);
    for (const Transform& start : starts) {
      CHECK(start.determinant() == doctest::Approx(1).epsilon(1e-12));
      CHECK(norm(start.direction({0, 0, 1}) - Vec3{0, 0, 1}) < 1e-12);
    }
  }
}

TEST_CASE("match_starts__hold_any_turn_of_what_has_three_axes") {
  Task task;
  const auto points = points_of_box({0.9, 0.5, 1.6}, 300, 2);
  const MatchSurface before(points, task);
  for (const Vec3& rotation : {Vec3{0.5, -0.3, 0.9}, Vec3{-2, 1, 1}, Vec3{}}) {
    const Transform truth = motion_about({0.2, 0, 1}, rotation, {-3, 0.4, 1});
    const MatchSurface after(moved(points, truth), task);
    const auto starts = match_starts(before, after, {});
    CHECK(left_by_best(starts, truth, points) < 1e-9);
    for (const Transform& start : starts) {
      CHECK(start.determinant() == doctest::Approx(1).epsilon(1e-12));
      CHECK(norm(start.direction({0.6, 0, 0.8})) == doctest::Approx(1).epsilon(1e-12));
    }
  }
}

TEST_CASE("match_starts__hold_the_fall_of_what_stood_onto_any_of_its_sides") {
  Task task;
  const auto points = points_of_box({0.5, 0.35, 1.1}, 300, 3);
  const MatchSurface before(points, task);
  MatchSetting setting;
  setting.stands = true;
  for (const Vec3& axis : {Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}}) {
    // Over, and then turned about up.
    const Transform fall = motion_about({}, axis * (90 * kDegree), {0.4, -0.2, 0}),
                    turn = motion_about({}, Vec3{0, 0, 1} * (40 * kDegree), {});
    const Transform truth = turn * fall;
    const MatchSurface after(moved(points, truth), task);
    CHECK(left_by_best(match_starts(before, after, setting), truth, points) < 1e-6);
  }
}
