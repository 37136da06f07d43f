// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "geometry/vec.h"

namespace jalon {

/// Does a set of points on a plane bend? Sums for the least-squares paraboloid d = c0 + c1 u + c2 v + c3 u^2 + c4 u v +
/// c5 v^2 over plane coordinates, 27 numbers whatever the points.
struct BendSums {
  std::array<double, 21> products{};  ///< of the six terms with each other, row by row, upper half
  std::array<double, 6> heights{};    ///< of the terms with d
  double squares = 0;
  uint64_t n = 0;

  /// u and v about the middle of the points, each divided by a length that makes it of order 1; d in metres.
  void add(double u, double v, double d);
  BendSums& operator+=(const BendSums& b);
};

/// Curvature of the paraboloid in the direction in which it bends most, 1 / m, with its standard deviation.
struct Bend {
  double curvature = 0, sigma = 0;
};
/// length_u, length_v: what u and v were divided by. False when the points do not fix the six coefficients.
bool largest_bend(const BendSums& sums, double length_u, double length_v, Bend& out);

}  // namespace jalon
