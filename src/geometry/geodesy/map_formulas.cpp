// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/geodesy/map_formulas.h"

#include <array>
#include <cmath>
#include <numbers>

namespace jalon {

namespace {

// Isometric latitude: of the conformal sphere, asinh(tan(conformal latitude)).
double isometric(const Ellipsoid& ellipsoid, double latitude) {
  const double s = std::sin(latitude), e = ellipsoid.e();
  return std::atanh(s) - e * std::atanh(e * s);
}

// The latitude of an isometric one: sin(latitude) = tanh(q + e atanh(e sin(latitude))).
double latitude_of(const Ellipsoid& ellipsoid, double q) {
  const double e = ellipsoid.e();
  double s = std::tanh(q);
  constexpr int kMost = 12;  // each step takes the error by e^2, 0.0067
  for (int step = 0; step < kMost; ++step) {
    const double next = std::tanh(q + e * std::atanh(e * s));
    if (next == s) break;
    s = next;
  }
  return std::atan2(std::sinh(q + e * std::atanh(e * s)), 1.0);
}

// Krueger's coefficients from the sphere to the ellipsoid and back, and the rectifying radius.
struct Kruger {
  std::array<double, 4> alpha, beta;
  double radius_m;
};

Kruger kruger(const Ellipsoid& ellipsoid) {
  const double n = ellipsoid.n(), n2 = n * n, n3 = n2 * n, n4 = n2 * n2;
  return {{n / 2 - 2 * n2 / 3 + 5 * n3 / 16 + 41 * n4 / 180,
           13 * n2 / 48 - 3 * n3 / 5 + 557 * n4 / 1440, 61 * n3 / 240 - 103 * n4 / 140,
           49561 * n4 / 161280},
          {n / 2 - 2 * n2 / 3 + 37 * n3 / 96 - n4 / 360, n2 / 48 + n3 / 15 - 437 * n4 / 1440,
           17 * n3 / 480 - 37 * n4 / 840, 4397 * n4 / 161280},
          ellipsoid.a_m / (1 + n) * (1 + n2 / 4 + n4 / 64)};
}

double parallel_radius(const Ellipsoid& ellipsoid, double latitude) {
  const double s = std::sin(latitude);
  return ellipsoid.a_m * std::cos(latitude) / std::sqrt(1 - ellipsoid.e2() * s * s);
}

// Of a conic: the cone's constant, and the distance from its tip at isometric latitude 0.
struct Cone {
  double constant, tip_m, origin_m;
};

Cone cone_of(const LambertConic& conic) {
  const double first = isometric(conic.ellipsoid, conic.first_parallel_rad),
               second = isometric(conic.ellipsoid, conic.second_parallel_rad);
  const double r1 = parallel_radius(conic.ellipsoid, conic.first_parallel_rad),
               r2 = parallel_radius(conic.ellipsoid, conic.second_parallel_rad);
  const double constant = std::log(r1 / r2) / (second - first);
  const double tip = r1 * std::exp(constant * first) / constant;
  return {constant, tip,
          tip * std::exp(-constant * isometric(conic.ellipsoid, conic.origin.latitude_rad))};
}

double within_a_turn(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

constexpr double kDegree2 = std::numbers::pi / 180;

}  // namespace

FlatPlace transverse_mercator(const Ellipsoid& ellipsoid, const Geodetic& place,
                              double meridian_rad) {
  const Kruger k = kruger(ellipsoid);
  const double east = within_a_turn(place.longitude_rad - meridian_rad);
  const double tau =
      std::sinh(isometric(ellipsoid, place.latitude_rad));  // tan(conformal latitude)
  const double xi = std::atan2(tau, std::cos(east));
  const double eta = std::asinh(std::sin(east) / std::hypot(tau, std::cos(east)));
  double x = eta, y = xi, p = 1, q = 0;
  for (size_t j = 0; j < 4; ++j) {
    const double m = 2 * static_cast<double>(j + 1), a = k.alpha[j];
    y += a * std::sin(m * xi) * std::cosh(m * eta);
    x += a * std::cos(m * xi) * std::sinh(m * eta);
    p += m * a * std::cos(m * xi) * std::cosh(m * eta);
    q += m * a * std::sin(m * xi) * std::sinh(m * eta);
  }
  const double s = std::sin(place.latitude_rad);
  const double convergence =
      std::atan2(tau * std::sin(east), std::cos(east) * std::hypot(1, tau)) + std::atan2(q, p);
  const double scale =
      k.radius_m / ellipsoid.a_m * std::hypot(p, q) * std::sqrt(1 - ellipsoid.e2() * s * s) *
      std::hypot(1, std::tan(place.latitude_rad)) / std::hypot(tau, std::cos(east));
  return {k.radius_m * x, k.radius_m * y, convergence, scale};
}

Geodetic inverse_transverse_mercator(const Ellipsoid& ellipsoid, const Vec3& position,
                                     double meridian_rad) {
  const Kruger k = kruger(ellipsoid);
  const double xi = position.y / k.radius_m, eta = position.x / k.radius_m;
  double xi_sphere = xi, eta_sphere = eta;
  for (size_t j = 0; j < 4; ++j) {
    const double m = 2 * static_cast<double>(j + 1), b = k.beta[j];
    xi_sphere -= b * std::sin(m * xi) * std::cosh(m * eta);
    eta_sphere -= b * std::cos(m * xi) * std::sinh(m * eta);
  }
  const double tau = std::sin(xi_sphere) / std::hypot(std::sinh(eta_sphere), std::cos(xi_sphere));
  return {latitude_of(ellipsoid, std::asinh(tau)),
          within_a_turn(meridian_rad + std::atan2(std::sinh(eta_sphere), std::cos(xi_sphere))),
          position.z};
}

// IGN NT/G 71 (1995) and the decree of 26 December 2000: 44 and 49 degrees, origin 3 degrees east of
// Greenwich at 46.5 degrees.
const LambertConic kLambert93Conic{
    kGrs80, 44 * kDegree2, 49 * kDegree2, {46.5 * kDegree2, 3 * kDegree2, 0}, 700000, 6600000};

FlatPlace lambert_conic(const LambertConic& conic, const Geodetic& place) {
  const Cone cone = cone_of(conic);
  const double turned =
      cone.constant * within_a_turn(place.longitude_rad - conic.origin.longitude_rad);
  const double from_tip =
      cone.tip_m * std::exp(-cone.constant * isometric(conic.ellipsoid, place.latitude_rad));
  return {conic.false_easting_m + from_tip * std::sin(turned),
          conic.false_northing_m + cone.origin_m - from_tip * std::cos(turned), turned,
          cone.constant * from_tip / parallel_radius(conic.ellipsoid, place.latitude_rad)};
}

Geodetic inverse_lambert_conic(const LambertConic& conic, const Vec3& position) {
  const Cone cone = cone_of(conic);
  const double x = position.x - conic.false_easting_m,
               y = cone.origin_m - (position.y - conic.false_northing_m);
  const double q = -std::log(std::hypot(x, y) / cone.tip_m) / cone.constant;
  return {latitude_of(conic.ellipsoid, q),
          within_a_turn(conic.origin.longitude_rad + std::atan2(x, y) / cone.constant), position.z};
}

}  // namespace jalon
