// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/vec.h"

namespace jalon {

/// Height function z = a x^2 + b x + c x y + d y + e y^2 + f (Girardeau-Montaut 2006, method 3 of
/// annex A.2), in a frame whose z axis is about the surface's normal.
struct Quadric {
  double a = 0, b = 0, c = 0, d = 0, e = 0, f = 0;

  double height(double x, double y) const {
    return a * x * x + b * x + c * x * y + d * y + e * y * y + f;
  }
  /// Unit normal of the graph over (x, y), on the side of +z.
  Vec3 normal(double x, double y) const;
  /// Mean curvature (1 / m), positive where the surface bends toward +z like a bowl.
  double mean_curvature(double x, double y) const;
  /// Gaussian curvature (1 / m^2).
  double gaussian_curvature(double x, double y) const;
};

/// What the least squares of heights are made of: sums of u^i v^j, i + j <= 4, and of those of degree 2 times the
/// height.
struct QuadricSums {
  double powers[5][5];   ///< [i][j]
  double heights[3][3];  ///< [i][j]
};
/// The six coefficients in the units of the sums. False when the points do not fix them: fewer than six, or all near
/// one conic. For coordinates of about 1, which balances the equations.
bool fit_quadric(const QuadricSums& sums, Quadric& out);

/// Least squares of the heights. scale: about the largest |x| or |y|, to balance the equations.
/// False when the points do not fix the six coefficients: fewer than six, or all near one conic.
bool fit_quadric(std::span<const Vec3> points, double scale, Quadric& out);

}  // namespace jalon
