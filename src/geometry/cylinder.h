// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "geometry/vec.h"

namespace jalon {

/// All points at the distance radius from an axis; direction is a unit vector.
struct Cylinder {
  Vec3 point;                 ///< of the axis
  Vec3 direction{0, 0, 1};
  double radius = 0;
  double axis_distance(const Vec3& p) const { return norm(cross(p - point, direction)); }
  /// Signed: positive outside.
  double distance(const Vec3& p) const { return axis_distance(p) - radius; }
};

/// A cylinder adjusted to points, with the covariance of its parameters. The point of the axis is the one at mid height.
struct CylinderFit {
  Cylinder cylinder;
  double length_m = 0;  ///< extent of the points along the axis
  uint64_t n = 0;       ///< points that carry it
  double sigma = 0;     ///< standard deviation of the distances, m
  std::array<double, 49> covariance{};  ///< of (point x, y, z, direction x, y, z, radius), row-major, rank 5
};

}  // namespace jalon
