// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/rough_angle.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

using namespace jalon;

TEST_CASE("rough_angle__is_the_angle_to_its_error_all_round_and_on_the_axes") {
  double worst = 0;
  for (int k = -36000; k <= 36000; ++k) {
    const double angle = std::numbers::pi * k / 36000, radius = 1e-3 * (1 + k * k % 1000);
    const double y = radius * std::sin(angle), x = radius * std::cos(angle);
    worst = std::max(worst, std::fabs(rough_angle(y, x) - std::atan2(y, x)));
  }
  CHECK(worst < kRoughAngleError_rad);
  for (const double y : {0.0, -0.0, 1.0, -1.0})
    for (const double x : {0.0, -0.0, 2.0, -2.0}) {
      CAPTURE(y);
      CAPTURE(x);
      CHECK(std::fabs(rough_angle(y, x) - std::atan2(y, x)) < kRoughAngleError_rad);
    }
}
