// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/geodesy/ellipsoid.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace jalon;

TEST_CASE("ellipsoid__earth_centred__agrees_with_proj_and_comes_back") {
  constexpr double kDeg = std::numbers::pi / 180;
  // PROJ 9.5.1: EPSG 4979 to 4978.
  const Vec3 paris = earth_centred(kWgs84, {48.85 * kDeg, 2.35 * kDeg, 35});
  CHECK(norm(paris - Vec3{4201496.66141, 172422.07960, 4779624.75520}) < 1e-5);
  const Vec3 south = earth_centred(kWgs84, {-89.3 * kDeg, -71.0 * kDeg, -50});
  CHECK(norm(south - Vec3{25453.95704, -73923.65892, -6356224.71449}) < 1e-5);
  for (double latitude = -90; latitude <= 90; latitude += 7.5)
    for (double height : {-1e5, -50.0, 0.0, 8848.0, 1e5}) {
      const Geodetic place{latitude * kDeg, 1.234, height};
      const Geodetic back = geodetic(kWgs84, earth_centred(kWgs84, place));
      CHECK(std::fabs(back.latitude_rad - place.latitude_rad) < 1e-13);
      CHECK(std::fabs(back.height_m - height) < 1e-6);
    }
}

TEST_CASE("ellipsoid__east_north_up__is_the_way_of_the_coordinates") {
  const Geodetic place{0.8, 0.3, 100};
  const Matrix3 axes = east_north_up(place);
  const Vec3 here = earth_centred(kGrs80, place);
  CHECK(norm(normalized(earth_centred(kGrs80, {0.8, 0.3 + 1e-7, 100}) - here) - axes.column(0)) <
        1e-6);
  CHECK(norm(normalized(earth_centred(kGrs80, {0.8 + 1e-7, 0.3, 100}) - here) - axes.column(1)) <
        1e-6);
  CHECK(norm(earth_centred(kGrs80, {0.8, 0.3, 101}) - here - axes.column(2)) < 1e-8);
}
