// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "fieldtools/field_values.h"
#include "unit/cloud/clouds.h"

namespace jalon::test {

/// A pebble (Girardeau-Montaut 2006, 3.3.2): half an ellipsoid of semi-axes 45, 35 and 30 mm on a
/// plane of 200 x 200 mm, 2 points a mm2; the field "distance" is the height above the plane, with
/// noise.
struct Pebble {
  Cloud cloud;
  std::vector<uint8_t> on_pebble;
};

inline Pebble pebble(double noise_m, uint64_t seed) {
  constexpr double kA = 0.045, kB = 0.035, kC = 0.030, kHalf = 0.1, kDensity = 2e6;
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  std::vector<double> heights;
  Pebble out;
  const auto add = [&](const Vec3& p, bool on) {
    const double noise = noise_m * random.normal();
    points.push_back({snapped(p.x), snapped(p.y), snapped(p.z + noise)});
    heights.push_back(std::fabs(points.back().z));
    out.on_pebble.push_back(on);
  };
  for (size_t i = 0; i < static_cast<size_t>(4 * kHalf * kHalf * kDensity); ++i) {
    const Vec3 p{kHalf * (2 * random.uniform() - 1), kHalf * (2 * random.uniform() - 1), 0};
    if (p.x * p.x / (kA * kA) + p.y * p.y / (kB * kB) > 1) add(p, false);
  }
  // Directions of the sphere, kept by the factor that the surface grows by.
  const double largest = kA * kB;
  const auto draws = static_cast<size_t>(2 * std::numbers::pi * largest * kDensity);
  for (size_t i = 0; i < draws; ++i) {
    const double z = random.uniform(), phi = 2 * std::numbers::pi * random.uniform(),
                 r = std::sqrt(1 - z * z);
    const Vec3 s{r * std::cos(phi), r * std::sin(phi), z};
    const double growth = kA * kB * kC * norm(Vec3{s.x / kA, s.y / kB, s.z / kC});
    if (random.uniform() * largest < growth) add({kA * s.x, kB * s.y, kC * s.z}, true);
  }
  out.cloud = with_field<double>(cloud_of(points), "distance", "m", "", heights);
  return out;
}

}  // namespace jalon::test
