// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/geodesy/ellipsoid.h"

namespace jalon {

struct FlatPlace {
  double x_m = 0, y_m = 0, convergence_rad = 0, scale = 1;
};

/// Transverse Mercator of scale 1 on the meridian, from the equator, by Krueger's series in the
/// third flattening (Krueger 1912 to n^4, in the form of Karney 2011): to 0.1 micrometre in a zone
/// of UTM.
FlatPlace transverse_mercator(const Ellipsoid& ellipsoid, const Geodetic& place,
                              double meridian_rad);
/// position: x, y and the height.
Geodetic inverse_transverse_mercator(const Ellipsoid& ellipsoid, const Vec3& position,
                                     double meridian_rad);

/// Conformal conic with two standard parallels (Snyder 1987, 15).
struct LambertConic {
  Ellipsoid ellipsoid;
  double first_parallel_rad = 0, second_parallel_rad = 0;
  Geodetic origin;
  double false_easting_m = 0, false_northing_m = 0;  ///< at the origin
};
extern const LambertConic kLambert93Conic;
FlatPlace lambert_conic(const LambertConic& conic, const Geodetic& place);
Geodetic inverse_lambert_conic(const LambertConic& conic, const Vec3& position);

}  // namespace jalon
