// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/segment/scenes.h"

// Two levels and the ramp between them: the test object of the comparison of 2006.
namespace jalon::test {

/// On a grid of 0.2 m, or so many times as dense; faces 1, 2 and 3, 0 on a break line.
inline Scene ramp(double noise_m, uint64_t seed, int denser = 1) {
  Scene scene;
  RandomStream random(seed, 4);
  for (int i = 0; i <= 50 * denser; ++i)
    for (int k = 0; k <= 15 * denser; ++k) {
      const double x = 0.2 * i / denser;
      const Vec3 p{x, 0.2 * k / denser, std::clamp(x - 4, 0.0, 2.0)};
      scene.points.push_back(p + noise_m * Vec3{random.normal(), random.normal(), random.normal()});
      const int low = 20 * denser, high = 30 * denser;
      scene.faces.push_back(i < low ? 1 : i == low || i == high ? 0 : i < high ? 2 : 3);
    }
  return scene;
}

struct RampResult {
  double angle_rad = 0;
  size_t wrong = 0;
  std::array<uint32_t, 3> labels{};  ///< of lower level, ramp and upper level
};
/// Requires three segments.
inline RampResult judge_ramp(const Scene& scene, const Segmentation& s) {
  constexpr double kHalf = std::numbers::sqrt2 / 2;
  constexpr Vec3 kNormals[] = {{0, 0, 1}, {-kHalf, 0, kHalf}, {0, 0, 1}};
  RampResult out;
  REQUIRE(s.segments.size() == 3);
  const auto labels = s.labels->values<uint32_t>();
  for (int face = 1; face <= 3; ++face) {
    uint32_t label = 0;
    for (uint32_t l = 1; l <= 3; ++l)
      if (label == 0 || overlap(scene, s, face, l) > overlap(scene, s, face, label)) label = l;
    out.labels[static_cast<size_t>(face - 1)] = label;
    const Vec3& n = s.segments[label - 1].fit.plane.normal;
    out.angle_rad = std::max(out.angle_rad, norm(cross(n, kNormals[face - 1])));
    for (size_t i = 0; i < labels.size(); ++i)
      out.wrong += scene.faces[i] == face && labels[i] != label;
  }
  return out;
}

/// x where two planes meet at y = 1.5, in the plane y = 1.5.
inline Vec3 meeting(const Plane& a, const Plane& b) {
  const double y = 1.5, pa = a.offset - a.normal.y * y, pb = b.offset - b.normal.y * y;
  const double d = a.normal.x * b.normal.z - b.normal.x * a.normal.z;
  return {(pa * b.normal.z - pb * a.normal.z) / d, y, (a.normal.x * pb - b.normal.x * pa) / d};
}

/// Areas of the three planes, 3 m wide, cut where they meet, from x = 0 to 10.
inline std::array<double, 3> ramp_areas(const Segmentation& s, const RampResult& r) {
  const auto plane = [&](size_t k) { return s.segments[r.labels[k] - 1].fit.plane; };
  const Vec3 low = meeting(plane(0), plane(1)), high = meeting(plane(1), plane(2));
  const auto end = [&](size_t k, double x) {
    const Plane p = plane(k);
    return Vec3{x, 1.5, (p.offset - p.normal.x * x - p.normal.y * 1.5) / p.normal.z};
  };
  return {3 * norm(low - end(0, 0)), 3 * norm(high - low), 3 * norm(end(2, 10) - high)};
}

}  // namespace jalon::test
