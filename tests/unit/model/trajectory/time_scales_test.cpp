// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/time_scales.h"

#include <doctest/doctest.h>

using namespace jalon;

TEST_CASE("shift_between_scales__of_the_day_the_week_and_adjusted_gps_time__is_found") {
  const TimeSpan of_day{36000, 36053};
  const TimeSpan of_week{36000 - 1 + 3 * 86400.0, 36054 + 3 * 86400.0};
  // Week 2391 of GPS.
  const TimeSpan adjusted{of_week.first_s + 2391 * 604800.0 - 1e9,
                          of_week.last_s + 2391 * 604800.0 - 1e9};
  CHECK(shift_between_scales(of_day, of_week).value() == -3 * 86400.0);
  CHECK(shift_between_scales(of_week, of_day).value() == 3 * 86400.0);
  CHECK(shift_between_scales(adjusted, of_week).value() == 2391 * 604800.0 - 1e9);
  CHECK(shift_between_scales(of_week, adjusted).value() == 1e9 - 2391 * 604800.0);
}

TEST_CASE("shift_between_scales__of_two_drives__is_none") {
  CHECK_FALSE(shift_between_scales({36000, 36053}, {40000, 40053}).has_value());
  CHECK_FALSE(
      shift_between_scales({36000, 36053}, {3 * 86400.0 + 36040, 3 * 86400.0 + 36093}).has_value());
}
