// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "geometry/vec.h"

namespace jalon {

/// |p - centre| = radius.
struct Sphere {
  Vec3 centre;
  double radius = 0;
  /// Signed: positive outside.
  double distance(const Vec3& p) const { return norm(p - centre) - radius; }
};

/// A sphere adjusted to points, with the covariance of its parameters.
struct SphereFit {
  Sphere sphere;
  uint64_t n = 0;    ///< points that carry it
  double sigma = 0;  ///< standard deviation of the distances, m
  std::array<double, 16> covariance{};  ///< of (centre x, y, z, radius), row-major
};

}  // namespace jalon
