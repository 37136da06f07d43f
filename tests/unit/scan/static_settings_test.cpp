// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/static_settings.h"

#include <doctest/doctest.h>

#include <string>

#include "base/error.h"

using namespace jalon;

TEST_CASE("static_settings__the_vertical_noise_is_the_horizontal_one_unless_told_otherwise") {
  StaticSettings s;
  s.angle_noise_rad = 3e-5;
  CHECK(resolved(s).vertical_noise_rad == 3e-5);
  s.vertical_noise_rad = 0;
  CHECK(resolved(s).vertical_noise_rad == 0);
  s.vertical_noise_rad = 1e-5;
  CHECK(resolved(s).vertical_noise_rad == 1e-5);
  CHECK(resolved(resolved(s)).vertical_noise_rad == 1e-5);
}

TEST_CASE("static_settings__the_gx_replaces_noise_and_beam_and_nothing_else") {
  StaticSettings s;
  s.range_noise_m = 0.5, s.range_noise_ppm = 100, s.beam_diameter_m = 0.1;
  s.vertical_noise_rad = 0.01;
  s.max_range_m = 77;
  CHECK(resolved(s).range_noise_m == 0.5);
  s.instrument = StaticSettings::Instrument::kGx;
  const StaticSettings gx = resolved(s);
  // Boulaassal 2010, table 3.1: 7 mm, 12" and 14"; 3 mm at 50 m.
  constexpr double kSecond_rad = std::numbers::pi / 180 / 3600;
  CHECK(gx.range_noise_m == 0.007);
  CHECK(gx.range_noise_ppm == 0);
  CHECK(gx.angle_noise_rad == doctest::Approx(12 * kSecond_rad).epsilon(0.04).scale(0));
  CHECK(gx.vertical_noise_rad == doctest::Approx(14 * kSecond_rad).epsilon(0.04).scale(0));
  CHECK(gx.beam_diameter_m + 50 * gx.beam_divergence_rad == doctest::Approx(0.003).scale(0));
  CHECK(gx.has_beam());
  CHECK(gx.max_range_m == 77);
}

TEST_CASE("static_settings__refuse_ranges_the_wrong_way_round") {
  StaticSettings s;
  s.min_range_m = 5, s.max_range_m = 5;
  CHECK(resolved(s).min_range_m == 5);
  s.max_range_m = 4.9;
  CHECK_THROWS_AS(resolved(s), Error);
}

TEST_CASE("static_settings__have_a_beam_only_with_a_width_and_sub_rays") {
  StaticSettings s;
  CHECK_FALSE(s.has_beam());
  s.beam_divergence_rad = 1e-4;
  CHECK(s.has_beam());
  s.beam_rings = 0;
  CHECK_FALSE(s.has_beam());
}
