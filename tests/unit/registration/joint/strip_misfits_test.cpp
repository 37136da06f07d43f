// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_misfits.h"

#include <doctest/doctest.h>

using namespace jalon;

TEST_CASE("strip_misfit_m__where_the_rest_stands__is_what_is_left_for_the_strip") {
  StripCondition strip;
  strip.normal = {0, 1};
  strip.distance_m = 2;
  strip.shares = {{0, 0.25}, {1, 0.75}};
  strip.turns_m = {0, 0, 10};
  JointPlaces places;
  places.trajectory = {{5, 0.4}, {5, 0.8}};
  places.model = {{{7, 0.5}}, {-0.3}, {99}};
  // n . (distance, block, facade, the drive back, 10 m for each radian of heading); its own offset does not count.
  CHECK(strip_misfit_m(strip, places, {}) == doctest::Approx(2 + 0.5 - 0.3 - 0.1 - 0.6));
  CHECK(strip_misfit_m(strip, places, {0, 0, 0.01}) == doctest::Approx(1.6));
}

TEST_CASE("rare_deviations__of_more_strips__are_more") {
  CHECK(rare_deviations(1) == doctest::Approx(1.959964));  // 5 % two-sided
  CHECK(rare_deviations(340) == doctest::Approx(3.80).epsilon(0.01));
}
