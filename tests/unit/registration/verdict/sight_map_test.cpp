// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/sight_map.h"

#include <doctest/doctest.h>

#include "base/random.h"

using namespace jalon;

namespace {

const Vec3 kOrigin{500000, 5000000, 100}, kStation{2, 3, 1};

// A wall at y = 8 before the station, from x = -8 to 12 and z = -4 to 6; with a square hole where asked.
std::vector<double> wall_points(bool has_hole) {
  RandomStream random(1, 1);
  std::vector<double> xyz;
  while (xyz.size() < 3 * 20000) {
    const Vec3 p{-8 + 20 * random.uniform(), 8, -4 + 10 * random.uniform()};
    if (has_hole && std::abs(p.x - 2) < 1.5 && std::abs(p.z - 1) < 1.5) continue;
    for (int axis = 0; axis < 3; ++axis) xyz.push_back(p[axis] + kOrigin[axis]);
  }
  return xyz;
}

SightMap map_of(const std::vector<double>& xyz) {
  Task task;
  return SightMap::build(xyz, kOrigin, kStation, 64, task);
}

}  // namespace

TEST_CASE("sight_map__tells_what_stands_before_on_and_behind_a_wall") {
  const SightMap map = map_of(wall_points(false));
  const Vec3 towards{0, 1, 0};
  for (const double x : {-3.0, 0.0, 2.0, 5.0})
    for (const double z : {-1.0, 1.0, 2.5}) {
      const auto at = [&](double t) { return kStation + (Vec3{x, 8, z} - kStation) * t; };
      CHECK(map.look(at(0.8), towards, 0.01) == Sighted::kThrough);
      CHECK(map.look(at(1.0), towards, 0.01) == Sighted::kSurface);
      CHECK(map.look(at(1.2), towards, 0.01) == Sighted::kHidden);
    }
}

TEST_CASE("sight_map__tells_nothing_where_nothing_was_measured") {
  const SightMap map = map_of(wall_points(true));
  CHECK(map.look({2, -5, 1}, {0, 1, 0}, 0.01) == Sighted::kUnknown);  // behind the scanner
  CHECK(map.look({2, 20, 1}, {0, 1, 0}, 0.01) == Sighted::kUnknown);  // through the hole
  CHECK(map.look(kStation, {0, 1, 0}, 0.01) == Sighted::kUnknown);
}

TEST_CASE("sight_map__says_nothing_of_surfaces_along_its_rays") {
  const SightMap map = map_of(wall_points(false));
  // A face that the ray runs along, just before the wall: in a cell it spans more than it is off.
  CHECK(map.look({2, 7.9, 1}, {1, 0, 0}, 0.001) == Sighted::kSurface);
  CHECK(map.look({2, 7.9, 1}, {0, 1, 0}, 0.001) == Sighted::kThrough);
}

TEST_CASE("sight_map__knows_points_that_its_station_cannot_have_seen") {
  std::vector<double> xyz = wall_points(false);
  const size_t hidden = xyz.size() / 3;
  for (const double v : {2.0, 12.0, 1.0})
    xyz.push_back(v + kOrigin[static_cast<int>(xyz.size() % 3)]);
  const SightMap map = map_of(xyz);
  CHECK(map.look_at_own({xyz[3 * hidden] - kOrigin.x, xyz[3 * hidden + 1] - kOrigin.y,
                         xyz[3 * hidden + 2] - kOrigin.z},
                        {0, 1, 0}, 0.01) == Sighted::kHidden);
  CHECK(map.look_at_own({2, 8, 1}, {0, 1, 0}, 0.01) == Sighted::kSurface);
  CHECK(map.look_at_own({2, -8, 1}, {0, 1, 0}, 0.01) == Sighted::kUnknown);
}
