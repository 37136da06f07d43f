// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/polar_covariance.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/random.h"

using namespace jalon;

namespace {

constexpr PolarSigmas kGx{0.007, 60e-6, 70e-6, 0, 0};  // Trimble GX: 7 mm, 12", 14"
const Vec3 kUp{0, 0, 1};

Vec3 polar_point(double d, double h, double v) {
  return {d * std::cos(v) * std::sin(h), d * std::cos(v) * std::cos(h), d * std::sin(v)};
}

}  // namespace

TEST_CASE("polar_covariance__gives_11_6_mm_at_100_m") {
  const double degrees[] = {0, 30, 45}, mm[] = {11.58, 11.18, 10.77};
  for (size_t i = 0; i < 3; ++i)
    for (const double h : {0.0, 1.0, 2.5, -2.0}) {
      const double v = degrees[i] * std::numbers::pi / 180;
      const double found = 1000 * point_sigma(polar_covariance(polar_point(100, h, v), kUp, kGx));
      if (h == 0)
        MESSAGE("FIGURE point precision at 100 m, ", degrees[i], " degrees up: ", found, " mm");
      CHECK(std::fabs(found - mm[i]) < 0.005);
    }
  // The printed third line of 5.5, cos v in place of sin v, would give 13.5 mm.
  CHECK(std::sqrt(0.006 * 0.006 + 0.007 * 0.007 + 0.007 * 0.007 + 0.007 * 0.007) > 0.0135);
}

TEST_CASE("polar_covariance__is_that_of_drawn_observations") {
  const double d = 40, h = 0.7, v = 0.5;
  const PolarSigmas sigmas{0.003, 4e-4, 2e-4, 0, 0};
  const Symmetric3 told = polar_covariance(polar_point(d, h, v), kUp, sigmas);
  RandomStream random(3, 3);
  constexpr int kDraws = 20000;
  Symmetric3 seen{};
  for (int k = 0; k < kDraws; ++k) {
    const double range = d + sigmas.range_m * random.normal(),
                 hor = h + sigmas.horizontal_rad * random.normal(),
                 ver = v + sigmas.vertical_rad * random.normal();
    const Vec3 e = polar_point(range, hor, ver) - polar_point(d, h, v);
    const double products[6] = {e.x * e.x, e.x * e.y, e.x * e.z, e.y * e.y, e.y * e.z, e.z * e.z};
    for (size_t i = 0; i < 6; ++i) seen[i] += products[i] / kDraws;
  }
  for (size_t i = 0; i < 6; ++i)
    CHECK(std::fabs(seen[i] - told[i]) < 0.03 * (told[0] + told[3] + told[5]) / 3);
}

TEST_CASE("polar_covariance__holds_overhead_and_adds_beam_and_levelling") {
  const Symmetric3 above = polar_covariance({0, 0, 10}, kUp, kGx);
  CHECK(above[5] == doctest::Approx(0.007 * 0.007).scale(0));
  CHECK(above[0] == doctest::Approx(above[3]).scale(0));
  CHECK(point_sigma(above) == doctest::Approx(std::hypot(0.007, 7e-4)).scale(0));
  const Symmetric3 nearly = polar_covariance({1e-9, 0, 10}, kUp, kGx);
  CHECK(point_sigma(nearly) == doctest::Approx(point_sigma(above)).scale(0));
  // 2 mm of beam in each direction across the ray, none along it.
  const Symmetric3 beam = polar_covariance({0, 50, 0}, kUp, {0.001, 0, 0, 0, 0.002});
  CHECK(beam[0] == doctest::Approx(4e-6).scale(0));
  CHECK(beam[3] == doctest::Approx(1e-6).scale(0));
  CHECK(beam[5] == doctest::Approx(4e-6).scale(0));
  // An axis tilted sideways moves what is high up, and nothing at the horizon.
  CHECK(polar_covariance({0, 30, 40}, kUp, {0, 0, 0, 1e-3, 0})[0] ==
        doctest::Approx(0.04 * 0.04).scale(0));
  CHECK(point_sigma(polar_covariance({0, 50, 0}, kUp, {0, 0, 0, 1e-3, 0})) == 0);
  CHECK(variance_along(beam, {0, 1, 0}) == doctest::Approx(1e-6).scale(0));
}
