// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/geodesy/map_projection.h"

#include <doctest/doctest.h>

#include <numbers>

using namespace jalon;

namespace {

constexpr double kDegreeRad = std::numbers::pi / 180;

struct KnownPlace {
  double latitude_deg, longitude_deg, x_m, y_m, convergence_deg, scale;
};

// PROJ 9.5.1 (pyproj 3.7.2): EPSG 32631, 32756 and 2154 with get_factors().
constexpr KnownPlace kUtm31[] = {
    {48.85, 2.35, 452314.89123, 5410984.88760, -0.4894523061, 0.999627934},
    {43.1, -0.2, 239587.48707, 4776891.23886, -2.1877016678, 1.000434324},
    {60.5, 6.0, 664762.85687, 6710852.70771, 2.6116484280, 0.999932657}};
constexpr KnownPlace kUtm56South = {-33.87,        151.2,        333510.65008,
                                    6250800.24118, 1.0033895425, 0.999941714};
constexpr KnownPlace kFrance[] = {
    {48.85, 2.35, 652301.56483, 6861302.72590, -0.4716450473, 0.999887800},
    {43.3, -1.5, 334836.34217, 6254945.12689, -3.2652349427, 1.000595002},
    {42.0, 9.1, 1205934.60988, 6119490.42832, 4.4262073668, 1.002074714}};

void agrees(const MapProjection& projection, const KnownPlace& known) {
  const Geodetic place{known.latitude_deg * kDegreeRad, known.longitude_deg * kDegreeRad, 35};
  const MapPlace made = projected(projection, place);
  CHECK(std::fabs(made.position.x - known.x_m) < 1e-5);
  CHECK(std::fabs(made.position.y - known.y_m) < 1e-5);
  CHECK(made.position.z == 35);
  CHECK(std::fabs(made.convergence_rad / kDegreeRad - known.convergence_deg) < 1e-9);
  CHECK(std::fabs(made.scale - known.scale) < 1e-9);
  const Geodetic back = unprojected(projection, made.position);
  CHECK(std::fabs(back.latitude_rad - place.latitude_rad) < 1e-13);
  CHECK(std::fabs(back.longitude_rad - place.longitude_rad) < 1e-13);
}

// Where a step to the east and to the north of a place leads on the map, per metre.
Vec3 step(const MapProjection& projection, const Geodetic& place, const Vec3& enu) {
  const Vec3 there = earth_centred(projection.ellipsoid(), place) + east_north_up(place) * enu;
  return (projected(projection, geodetic(projection.ellipsoid(), there)).position -
          projected(projection, place).position) /
         norm(enu);
}

}  // namespace

TEST_CASE("map_projection__utm_and_lambert_93__agree_with_proj") {
  for (const KnownPlace& known : kUtm31) agrees({MapSystem::kUtm, 31, false, {}}, known);
  agrees({MapSystem::kUtm, 56, true, {}}, kUtm56South);
  for (const KnownPlace& known : kFrance) agrees({MapSystem::kLambert93, 0, false, {}}, known);
  CHECK(MapProjection{MapSystem::kUtm, 56, true, {}}.crs() == "EPSG:32756");
  CHECK(MapProjection{MapSystem::kLambert93, 0, false, {}}.crs() == "EPSG:2154");
}

TEST_CASE("map_projection__a_step_north__turns_by_the_convergence") {
  const Geodetic place{48.85 * kDegreeRad, 2.35 * kDegreeRad, 0};
  for (const MapProjection& projection :
       {MapProjection{MapSystem::kUtm, 31, false, {}},
        MapProjection{MapSystem::kLambert93, 0, false, {}},
        MapProjection{MapSystem::kEnu, 0, false, {48.8 * kDegreeRad, 2.2 * kDegreeRad, 0}}}) {
    const MapPlace made = projected(projection, place);
    for (const Vec3& way : {Vec3{0, 1, 0}, Vec3{1, 0, 0}}) {
      const Vec3 seen = step(projection, place, way) / made.scale, said = made.T_world_local * way;
      CHECK(norm(seen - said) < 2e-6);
    }
  }
}

TEST_CASE("map_projection__local_axes__begin_at_the_origin_and_keep_lengths") {
  const Geodetic origin{48.85 * kDegreeRad, 2.35 * kDegreeRad, 35};
  const MapProjection local{MapSystem::kEnu, 0, false, origin};
  CHECK(norm(projected(local, origin).position) < 1e-9);
  const Geodetic away{48.95 * kDegreeRad, 2.55 * kDegreeRad, 80};
  const Vec3 there = projected(local, away).position;
  CHECK(norm(there) ==
        doctest::Approx(norm(earth_centred(kWgs84, away) - earth_centred(kWgs84, origin))));
  CHECK(there.z < 45 - 20);  // the Earth bends away by s^2 / 2 R: 27 m at 18.5 km
  const Geodetic back = unprojected(local, there);
  CHECK(std::fabs(back.latitude_rad - away.latitude_rad) < 1e-14);
  CHECK(std::fabs(back.height_m - 80) < 1e-7);
}

TEST_CASE("utm_zone__of_a_longitude__is_the_one_that_holds_it") {
  CHECK(utm_zone(2.35 * kDegreeRad) == 31);
  CHECK(utm_zone(-0.2 * kDegreeRad) == 30);
  CHECK(utm_zone(151.2 * kDegreeRad) == 56);
  CHECK(utm_zone(-180 * kDegreeRad) == 1);
  CHECK(utm_zone(362.35 * kDegreeRad) == 31);
}
