// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/geodesy/ellipsoid.h"

namespace jalon {

Vec3 earth_centred(const Ellipsoid& ellipsoid, const Geodetic& place) {
  const double s = std::sin(place.latitude_rad), c = std::cos(place.latitude_rad);
  const double across = ellipsoid.a_m / std::sqrt(1 - ellipsoid.e2() * s * s);
  const double from_axis = (across + place.height_m) * c;
  return {from_axis * std::cos(place.longitude_rad), from_axis * std::sin(place.longitude_rad),
          (across * (1 - ellipsoid.e2()) + place.height_m) * s};
}

Geodetic geodetic(const Ellipsoid& ellipsoid, const Vec3& p) {
  const double a = ellipsoid.a_m, b = a * (1 - ellipsoid.flattening), e2 = ellipsoid.e2();
  const double from_axis = std::hypot(p.x, p.y);
  double reduced = std::atan2(p.z * a, from_axis * b);  // latitude on the sphere around
  double latitude = 0;
  constexpr int kSteps = 4;  // each takes the error by about e^4
  for (int step = 0; step < kSteps; ++step) {
    const double s = std::sin(reduced), c = std::cos(reduced);
    latitude = std::atan2(p.z + e2 / (1 - e2) * b * s * s * s, from_axis - e2 * a * c * c * c);
    reduced = std::atan2((1 - ellipsoid.flattening) * std::sin(latitude), std::cos(latitude));
  }
  const double s = std::sin(latitude), c = std::cos(latitude);
  // Along the normal, good at the equator and at the poles alike.
  const double height = from_axis * c + p.z * s - a * std::sqrt(1 - e2 * s * s);
  return {latitude, std::atan2(p.y, p.x), height};
}

Matrix3 east_north_up(const Geodetic& place) {
  const double sp = std::sin(place.latitude_rad), cp = std::cos(place.latitude_rad);
  const double sl = std::sin(place.longitude_rad), cl = std::cos(place.longitude_rad);
  return {{-sl, -sp * cl, cp * cl, cl, -sp * sl, cp * sl, 0, cp, sp}};
}

}  // namespace jalon
