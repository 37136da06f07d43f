// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rotation.h"
#include "geometry/vec.h"

namespace jalon {

/// Figure of the Earth: half its width at the equator and its flattening.
struct Ellipsoid {
  double a_m = 0, flattening = 0;

  constexpr double e2() const {
    return flattening * (2 - flattening);
  }  ///< first eccentricity squared
  double e() const { return std::sqrt(e2()); }
  /// The third flattening.
  constexpr double n() const { return flattening / (2 - flattening); }
};
/// NIMA TR8350.2 (2000); Moritz 1980.
inline constexpr Ellipsoid kWgs84{6378137, 1 / 298.257223563};
inline constexpr Ellipsoid kGrs80{6378137, 1 / 298.257222101};

/// A place on the Earth; the height is above the ellipsoid.
struct Geodetic {
  double latitude_rad = 0, longitude_rad = 0, height_m = 0;
};

/// Earth-centred, earth-fixed coordinates (m), and back, to less than a micrometre up to 100 km
/// above and below the ellipsoid (Bowring 1976, repeated until it stands).
Vec3 earth_centred(const Ellipsoid& ellipsoid, const Geodetic& place);
Geodetic geodetic(const Ellipsoid& ellipsoid, const Vec3& earth_centred_m);

/// The rotation from east, north, up at this place to earth-centred axes.
Matrix3 east_north_up(const Geodetic& place);

}  // namespace jalon
