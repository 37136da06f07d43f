// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/geodesy/map_projection.h"

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/geodesy/map_formulas.h"

namespace jalon {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

// Universal transverse Mercator (NGA.SIG.0012, 2014).
constexpr double kUtmScale = 0.9996, kUtmEasting_m = 500000, kUtmSouth_m = 10000000;

double central_meridian(int zone) { return (6 * zone - 183) * kDegree; }

MapPlace of_map(const FlatPlace& flat, double height_m) {
  return {{flat.x_m, flat.y_m, height_m},
          rotation_z(flat.convergence_rad),
          flat.convergence_rad,
          flat.scale};
}

}  // namespace

std::string MapProjection::crs() const {
  if (system == MapSystem::kLambert93) return "EPSG:2154";
  if (system == MapSystem::kEnu) return "";
  return "EPSG:" + std::to_string((is_south ? 32700 : 32600) + zone);
}

int utm_zone(double longitude_rad) {
  const double turns = longitude_rad / (2 * std::numbers::pi) + 0.5;
  const int zone = static_cast<int>(std::floor((turns - std::floor(turns)) * 60)) + 1;
  return zone > 60 ? 60 : zone;
}

MapPlace projected(const MapProjection& projection, const Geodetic& place) {
  if (projection.system == MapSystem::kLambert93)
    return of_map(lambert_conic(kLambert93Conic, place), place.height_m);
  if (projection.system == MapSystem::kUtm) {
    FlatPlace flat = transverse_mercator(kWgs84, place, central_meridian(projection.zone));
    flat.x_m = kUtmEasting_m + kUtmScale * flat.x_m;
    flat.y_m = kUtmScale * flat.y_m + (projection.is_south ? kUtmSouth_m : 0);
    flat.scale *= kUtmScale;
    return of_map(flat, place.height_m);
  }
  const Matrix3 T_origin_earth = transposed(east_north_up(projection.origin));
  return {
      T_origin_earth * (earth_centred(kWgs84, place) - earth_centred(kWgs84, projection.origin)),
      T_origin_earth * east_north_up(place), 0, 1};
}

Geodetic unprojected(const MapProjection& projection, const Vec3& position) {
  if (projection.system == MapSystem::kLambert93)
    return inverse_lambert_conic(kLambert93Conic, position);
  if (projection.system == MapSystem::kUtm) {
    const Vec3 flat{(position.x - kUtmEasting_m) / kUtmScale,
                    (position.y - (projection.is_south ? kUtmSouth_m : 0)) / kUtmScale, position.z};
    return inverse_transverse_mercator(kWgs84, flat, central_meridian(projection.zone));
  }
  return geodetic(kWgs84, earth_centred(kWgs84, projection.origin) +
                              east_north_up(projection.origin) * position);
}

}  // namespace jalon
