// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The motion planted between two scans of the street: half a metre and three degrees in directions drawn from a seed,
// the turn about the middle of the street; and how far a pose that was found is off.

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "street_points.h"

namespace bench {

constexpr double kShift_m = 0.5;
constexpr double kTurn_rad = 3 * std::numbers::pi / 180;
constexpr Vec kStreetMiddle = {30, 0, 6};  // before the street is turned
// Of coordinates that keep their bits below the national grid's seven digits, and in floats within 64 m.
constexpr double kSnap_m = 0x1p-18;

using Rows = std::array<double, 12>;  // [R | t], three rows

inline Vec moved(const Rows& T, Vec p) {
  return {T[0] * p.x + T[1] * p.y + T[2] * p.z + T[3], T[4] * p.x + T[5] * p.y + T[6] * p.z + T[7],
          T[8] * p.x + T[9] * p.y + T[10] * p.z + T[11]};
}

inline Vec unit_direction(Random& random) {
  const Vec v = {random.normal(), random.normal(), random.normal()};
  return v * (1 / std::sqrt(dot(v, v)));
}

/// The rotation by Rodrigues' formula about the middle of the turned street, then the shift.
inline Rows planted_motion(uint64_t seed) {
  Random random(seed);
  const Vec k = unit_direction(random), shift = unit_direction(random) * kShift_m,
            middle = turned(kStreetMiddle);
  const double c = std::cos(kTurn_rad), s = std::sin(kTurn_rad);
  const auto rotated = [&](Vec p) { return p * c + cross(k, p) * s + k * (dot(k, p) * (1 - c)); };
  const Vec x = rotated({1, 0, 0}), y = rotated({0, 1, 0}), z = rotated({0, 0, 1});
  const Vec t = middle + shift - rotated(middle);
  return {x.x, y.x, z.x, t.x, x.y, y.y, z.y, t.y, x.z, y.z, z.z, t.z};
}

inline std::vector<double> moved(const Rows& T, const std::vector<double>& xyz) {
  std::vector<double> out;
  out.reserve(xyz.size());
  for (size_t i = 0; i < xyz.size(); i += 3) {
    const Vec p = moved(T, Vec{xyz[i], xyz[i + 1], xyz[i + 2]});
    for (const double value : {p.x, p.y, p.z}) out.push_back(static_cast<float>(value));
  }
  return out;
}

inline void snap(std::vector<double>& xyz, Vec origin) {
  for (size_t i = 0; i < xyz.size(); ++i) {
    const double offset = i % 3 == 0 ? origin.x : i % 3 == 1 ? origin.y : origin.z;
    xyz[i] = std::nearbyint(xyz[i] / kSnap_m) * kSnap_m + offset;
  }
}

struct PoseError {
  double shift_m = 0;  // at the middle of the street
  Vec parts_m;         // along, across and above the street
  double turn_deg = 0;
};

/// pose: T_reference_moving of the coordinates given, whose origin lies at origin of the street's.
inline PoseError pose_error(const Rows& pose, const Rows& motion, Vec origin) {
  const Vec middle = turned(kStreetMiddle);
  const Vec off = moved(pose, moved(motion, middle) + origin) - origin - middle;
  const auto entry = [&](size_t i, size_t j) {  // of the rotation left over
    return pose[4 * i] * motion[j] + pose[4 * i + 1] * motion[4 + j] +
           pose[4 * i + 2] * motion[8 + j];
  };
  const Vec axis =
      Vec{entry(2, 1) - entry(1, 2), entry(0, 2) - entry(2, 0), entry(1, 0) - entry(0, 1)} * 0.5;
  const double trace = entry(0, 0) + entry(1, 1) + entry(2, 2);
  const double angle = std::atan2(std::sqrt(dot(axis, axis)), (trace - 1) / 2);
  const double tc = std::cos(kStreetTurn), ts = std::sin(kStreetTurn);
  return {std::sqrt(dot(off, off)),
          {tc * off.x + ts * off.y, tc * off.y - ts * off.x, off.z},
          angle * 180 / std::numbers::pi};
}

}  // namespace bench
