// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/misfit.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace jalon;

namespace {

Transform pose_at(const Vec3& p) {
  Transform pose;
  for (int a = 0; a < 3; ++a) pose.m[static_cast<size_t>(4 * a + 3)] = p[a];
  return pose;
}

}  // namespace

TEST_CASE("misfit__of_zero_deviations_changes_no_bit") {
  const Misfit misfit(StaticSettings{}, 3);
  CHECK(misfit.is_none());
  const Transform pose = pose_at({652000.1, 6861000.2, 100.3});
  CHECK(misfit.recorded(pose).m == pose.m);
  CHECK(misfit.recorded({1, 2, 3}, {0.1, 0.2, 0.3}) == Vec3{1 + 0.1, 2 + 0.2, 3 + 0.3});
}

TEST_CASE("misfit__moves_points_as_a_rigid_motion_about_the_station") {
  StaticSettings settings;
  settings.misfit_shift_m = 0.01;
  settings.misfit_rotation_rad = 0.02;
  const Misfit misfit(settings, 0);
  REQUIRE_FALSE(misfit.is_none());
  const Vec3 centre{10, 20, 30}, a{5, 1, -2}, b{-3, 4, 1};
  const Vec3 at_centre = misfit.recorded(centre, {});
  const Vec3 from_centre_a = misfit.recorded(centre, a) - at_centre,
             from_centre_b = misfit.recorded(centre, b) - at_centre;
  CHECK(norm(from_centre_a) == doctest::Approx(norm(a)).epsilon(1e-12));
  CHECK(dot(from_centre_a, from_centre_b) == doctest::Approx(dot(a, b)).epsilon(1e-12));
  CHECK(dot(cross(from_centre_a, from_centre_b), misfit.recorded(centre, cross(a, b)) - at_centre) >
        0);  // no mirror
  CHECK(norm(at_centre - centre) > 0);
  CHECK(norm(from_centre_a - a) > 0);
}

TEST_CASE("misfit__of_the_pose_and_of_the_points_is_one_error") {
  StaticSettings settings;
  settings.misfit_shift_m = 0.01;
  settings.misfit_rotation_rad = 0.02;
  const Misfit misfit(settings, 1);
  const Vec3 centre{10, 20, 30};
  const Transform recorded = misfit.recorded(pose_at(centre));
  // What the scanner sees in its own axes, put down with the recorded pose, is the recorded point.
  const Vec3 seen{4, -7, 2};
  CHECK(norm(recorded.point(seen) - misfit.recorded(centre, seen)) < 1e-12);
}

TEST_CASE("misfit__differs_between_stations_and_seeds_and_has_its_deviation") {
  StaticSettings settings;
  settings.misfit_shift_m = 0.5;
  double squares = 0;
  constexpr size_t kStations = 500;
  for (size_t s = 0; s < kStations; ++s) {
    const Misfit misfit(settings, s);
    const Vec3 shift = misfit.recorded(Vec3{}, Vec3{});
    squares += squared_norm(shift) / 0.25;
  }
  // Chi-squared of 1500 degrees of freedom, within five standard deviations.
  CHECK(std::abs(squares - 3 * kStations) < 5 * std::sqrt(6.0 * kStations));
  StaticSettings other = settings;
  other.seed = 2;
  CHECK_FALSE(Misfit(settings, 0).recorded(Vec3{}, Vec3{}) ==
              Misfit(other, 0).recorded(Vec3{}, Vec3{}));
}
