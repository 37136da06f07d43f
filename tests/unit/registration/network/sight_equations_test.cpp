// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/sight_equations.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace jalon;

TEST_CASE("sights__derivatives_are_those_of_finite_differences") {
  NetworkSettings settings;
  settings.scale = 0.9997;
  const Vec3 from{3, -2, 1};
  for (const Vec3& to : {Vec3{40, 25, 4}, Vec3{-300, 80, -20}, Vec3{5, -900, 60}})
    for (const auto kind : {SightKind::kDirection, SightKind::kZenith, SightKind::kDistance}) {
      const SightEquation made = sight_equation(kind, from, to, settings);
      for (int axis = 0; axis < 3; ++axis) {
        constexpr double kStep = 1e-4;
        Vec3 low = to, high = to;
        low[axis] -= kStep, high[axis] += kStep;
        const double slope = (sight_equation(kind, from, high, settings).value -
                              sight_equation(kind, from, low, settings).value) /
                             (2 * kStep);
        CHECK(made.by_target[axis] == doctest::Approx(slope).epsilon(1e-6).scale(1e-3));
      }
    }
}

TEST_CASE("sights__the_earth_bends_away_and_refraction_bends_after_it") {
  NetworkSettings settings;
  const Vec3 far{0, 1000, 0};
  const double level = std::numbers::pi / 2;
  // 1 km: 78.5 mm for the Earth, less 13 %.
  CHECK(sight_equation(SightKind::kZenith, {}, far, settings).value - level ==
        doctest::Approx(0.0683e-3).epsilon(0.01).scale(0));
  settings.refraction = 1;
  CHECK(sight_equation(SightKind::kZenith, {}, far, settings).value == doctest::Approx(level));
}

TEST_CASE("sights__two_points_in_one_place_have_no_direction_and_no_number_that_is_none") {
  for (const auto kind : {SightKind::kDirection, SightKind::kZenith, SightKind::kDistance})
    CHECK(is_finite(sight_equation(kind, {1, 1, 1}, {1, 1, 1}, {}).by_target));
}

TEST_CASE("sights__angles_lose_whole_turns") {
  CHECK(within_half_turn(7) == doctest::Approx(7 - 2 * std::numbers::pi));
  CHECK(within_half_turn(-3) == -3);
}
