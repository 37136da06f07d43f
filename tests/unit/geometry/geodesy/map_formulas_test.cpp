// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/geodesy/map_formulas.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace jalon;

TEST_CASE("transverse_mercator__on_the_meridian__is_the_length_of_its_arc") {
  // A quarter of the meridian of WGS 84: 10 001 965.7293 m.
  const FlatPlace pole = transverse_mercator(kWgs84, {std::numbers::pi / 2 - 1e-13, 0.5, 0}, 0.5);
  CHECK(pole.y_m == doctest::Approx(10001965.7293).epsilon(1e-11));
  CHECK(std::fabs(pole.x_m) < 1e-6);
  CHECK(transverse_mercator(kWgs84, {0.7, 0.5, 0}, 0.5).scale == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("map_formulas__both_ways__come_back_to_a_micrometre") {
  constexpr double kMicrometre = 1.6e-13;  // of an angle on the Earth
  for (double latitude = -1.4; latitude < 1.5; latitude += 0.2)
    for (double east = -0.08; east < 0.09; east += 0.02) {
      const Geodetic place{latitude, 3.1 + east, 7};  // across the 180th meridian
      const FlatPlace flat = transverse_mercator(kWgs84, place, 3.1);
      const Geodetic back = inverse_transverse_mercator(kWgs84, {flat.x_m, flat.y_m, 7}, 3.1);
      CHECK(std::fabs(back.latitude_rad - latitude) < kMicrometre);
      CHECK(std::fabs(std::remainder(back.longitude_rad - place.longitude_rad,
                                     2 * std::numbers::pi)) < 10 * kMicrometre);
    }
  for (double latitude = 0.7; latitude < 0.92; latitude += 0.05) {
    const FlatPlace flat = lambert_conic(kLambert93Conic, {latitude, -0.08, 0});
    const Geodetic back = inverse_lambert_conic(kLambert93Conic, {flat.x_m, flat.y_m, 0});
    CHECK(std::fabs(back.latitude_rad - latitude) < kMicrometre);
    CHECK(std::fabs(back.longitude_rad + 0.08) < kMicrometre);
  }
}

TEST_CASE("lambert_conic__on_its_parallels__keeps_lengths") {
  constexpr double kDegrees = std::numbers::pi / 180;
  CHECK(lambert_conic(kLambert93Conic, {44 * kDegrees, 0.05, 0}).scale ==
        doctest::Approx(1).epsilon(1e-14));
  CHECK(lambert_conic(kLambert93Conic, {49 * kDegrees, 0.09, 0}).scale ==
        doctest::Approx(1).epsilon(1e-14));
}
