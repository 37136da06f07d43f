// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/geodesy/ellipsoid.h"

namespace jalon {

enum class MapSystem {
  kUtm,        ///< on WGS 84
  kLambert93,  ///< on GRS 80: the French system (EPSG 2154)
  kEnu,        ///< east, north, up at an origin, on WGS 84: no map, straight lines stay straight
};

/// A choice of world for what comes in latitude and longitude.
struct MapProjection {
  MapSystem system = MapSystem::kUtm;
  int zone = 31;          ///< of UTM, 1 ... 60
  bool is_south = false;  ///< of UTM: northings from 10 000 km at the equator
  Geodetic origin;        ///< of kEnu

  const Ellipsoid& ellipsoid() const { return system == MapSystem::kLambert93 ? kGrs80 : kWgs84; }
  /// "EPSG:32631"; "" for kEnu, which has none.
  std::string crs() const;
};
/// The zone of UTM that a longitude lies in.
int utm_zone(double longitude_rad);

/// A place in the world and how its surroundings lie there.
struct MapPlace {
  Vec3 position;
  /// From east, north, up at the place to the world's axes: about the vertical by the meridian
  /// convergence (grid north east of true north: positive), with kEnu also by the Earth's bend.
  Matrix3 T_world_local;
  double convergence_rad = 0;
  double scale = 1;  ///< lengths on the map over lengths on the ellipsoid
};
/// Heights stay those above the ellipsoid with maps. To less than 0.1 mm within 10 degrees of the
/// zone's meridian.
MapPlace projected(const MapProjection& projection, const Geodetic& place);
Geodetic unprojected(const MapProjection& projection, const Vec3& position);

}  // namespace jalon
