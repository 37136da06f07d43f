// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/symmetric_eigen.h"
#include "geometry/vec.h"

namespace jalon {

/// C += scale v v^T.
inline void add_square(Symmetric3& c, const Vec3& v, double scale) {
  c[0] += scale * v.x * v.x;
  c[1] += scale * v.x * v.y;
  c[2] += scale * v.x * v.z;
  c[3] += scale * v.y * v.y;
  c[4] += scale * v.y * v.z;
  c[5] += scale * v.z * v.z;
}

/// What moves a scanned point across and along its ray, uncorrelated (Boulaassal 2010, 5.3.3).
struct PolarSigmas {
  double range_m = 0;
  double horizontal_rad = 0;  ///< of the horizontal angle: moves a point by d cos v times it
  double vertical_rad = 0;    ///< of the vertical angle
  double levelling_rad =
      0;  ///< a tilt of the vertical axis across the ray: moves it sideways by d sin v times it
  double lateral_m = 0;  ///< across the ray in any direction, e.g. of the beam's width
};

/// Covariance (m2) of a point at `ray` from the scanner, in the frame of `ray` and up (unit, the scanner's vertical
/// axis): C = J diag(sd2, sv2, sh2) J^T with X = d cos v sin h, Y = d cos v cos h, Z = d sin v (Boulaassal 2010, 5.4,
/// 5.5 with sin v in the last line, where the thesis prints cos v). Below and above the scanner the horizontal angle
/// moves nothing. ray must not be 0.
Symmetric3 polar_covariance(const Vec3& ray, const Vec3& up, const PolarSigmas& sigmas);

/// sqrt(sX2 + sY2 + sZ2), 5.6: independent of the horizontal angle.
double point_sigma(const Symmetric3& covariance);

/// n^T C n.
double variance_along(const Symmetric3& covariance, const Vec3& n);

}  // namespace jalon
