// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// A head in a room of 8 x 6 m: lines of points on its walls, and the plane of the level beam.

#include "segment/settle/planes_of_lines.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr int kLevel = 5, kWall = 1;  // faces: walls 1 ... 4 and the level beam's points

// One turn in steps of 0.2 degrees: beams degrees_apart from -10 to 10 degrees, noise along them.
Scene turn(double degrees_apart, double noise_m) {
  constexpr double kDegree = std::numbers::pi / 180;
  Scene out;
  RandomStream random(3, 1);
  const int beams = static_cast<int>(10 / degrees_apart);
  for (int beam = -beams; beam <= beams; ++beam)
    for (int step = 0; step < 1800; ++step) {
      const double up = beam * degrees_apart * kDegree, turned = step * 0.2 * kDegree;
      const Vec3 d{std::cos(turned) * std::cos(up), std::sin(turned) * std::cos(up), std::sin(up)};
      const double along_x = (d.x > 0 ? 4.5 : 3.5) / std::abs(d.x),
                   along_y = (d.y > 0 ? 3.2 : 2.8) / std::abs(d.y);
      const int wall =
          along_x < along_y ? (d.x > 0 ? kWall : kWall + 1) : (d.y > 0 ? kWall + 2 : kWall + 3);
      const double range = std::min(along_x, along_y) + noise_m * random.normal();
      out.points.push_back(d * range);
      out.faces.push_back(beam == 0 ? kLevel : wall);
    }
  return out;
}

}  // namespace

TEST_CASE("drop_planes_of_lines__takes_the_level_beam_for_no_plane_and_keeps_the_walls") {
  const Scene room = turn(2, 0.01);
  MadeScene made(room.points);
  auto surfaces = made.surfaces(room.faces, kLevel);
  REQUIRE(std::abs(surfaces[kLevel - 1].plane.normal.z) > 0.99);
  drop_planes_of_lines(made.scene, surfaces, made.task);
  REQUIRE(surfaces.size() == kLevel - 1);
  size_t free = 0;
  for (size_t p = 0; p < made.scene.size(); ++p) free += made.scene.owner[p] == 0;
  CHECK(free == 1800);
  for (const Surface& wall : surfaces) CHECK(std::abs(wall.plane.normal.z) < 0.1);
}

TEST_CASE(
    "drop_planes_of_lines__takes_the_level_beam_for_no_plane_where_noise_fills_the_tolerance") {
  const Scene room = turn(2, 0.02);
  MadeScene made(room.points);
  auto surfaces = made.surfaces(room.faces, kLevel);
  drop_planes_of_lines(made.scene, surfaces, made.task);
  CHECK(surfaces.size() == kLevel - 1);
}

TEST_CASE("drop_planes_of_lines__a_strip_of_even_points_across_a_wall_stays") {
  Scene wall;
  RandomStream random(4, 1);
  wall.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 0, 3}, 40000, 0.003, random);
  wall.rectangle(2, {0, 0, 1.4}, {4, 0, 0}, {0, -0.06, 0}, 2000, 0.003, random);  // a ledge
  MadeScene made(wall.points);
  auto surfaces = made.surfaces(wall.faces, 2);
  drop_planes_of_lines(made.scene, surfaces, made.task);
  CHECK(surfaces.size() == 2);
}

TEST_CASE("drop_planes_of_lines__joinery_two_points_wide_in_a_window_stays") {
  constexpr int kSurround = 2, kJoinery = 3;
  // Of walls of several widths: each has the octree's cells elsewhere about the window.
  for (const double beside_m : {1.3, 2.8, 3.7, 4.6, 6.1}) {
    Scene house;
    RandomStream random(6, 1);
    const auto strip = [&](int face, double x0, double x1, double y, double z0, double z1) {
      const auto points = static_cast<size_t>((x1 - x0) * (z1 - z0) / (0.04 * 0.04));
      house.rectangle(face, {x0, y, z0}, {x1 - x0, 0, 0}, {0, 0, z1 - z0}, points, 0.006, random);
    };
    // Strips around a window of 1.2 x 1.8 m.
    const auto ring = [&](int face, double y, double inner, double outer) {
      strip(face, -outer, 1.2 + outer, y, -outer, -inner);
      strip(face, -outer, 1.2 + outer, y, 1.8 + inner, 1.8 + outer);
      strip(face, -outer, -inner, y, -inner, 1.8 + inner);
      strip(face, 1.2 + inner, 1.2 + outer, y, -inner, 1.8 + inner);
    };
    ring(1, 0, 0.15, beside_m);
    ring(kSurround, -0.06, 0, 0.15);
    ring(kJoinery, 0.2, -0.08, 0);
    MadeScene made(house.points);
    auto surfaces = made.surfaces(house.faces, kJoinery);
    drop_planes_of_lines(made.scene, surfaces, made.task);
    CHECK(surfaces.size() == kJoinery);
  }
}

TEST_CASE("drop_planes_of_lines__lines_side_by_side_in_one_plane_stay") {
  Scene floor;
  RandomStream random(5, 1);
  for (int line = 0; line < 40; ++line)
    for (int i = 0; i < 400; ++i) {
      floor.points.push_back({0.01 * i, 0.15 * line, 0.004 * random.normal()});
      floor.faces.push_back(line == 20 ? 2 : 1);
    }
  MadeScene made(floor.points);
  auto surfaces = made.surfaces(floor.faces, 2);
  surfaces[1].plane = surfaces[0].plane;  // of one line least squares tell nothing about its turn
  drop_planes_of_lines(made.scene, surfaces, made.task);
  CHECK(surfaces.size() == 2);
}
