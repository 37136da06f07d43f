// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "unit/registration/target_walls.h"

namespace jalon::test {

/// Targets of three entries and of two sizes that are in none, among what is no target.
inline constexpr const char* kWallCatalogue = R"({"targets": [
  {"code": "1", "name": "wall", "kind": "checker", "size_m": 0.15},
  {"code": "2", "name": "door", "kind": "checker", "size_m": 0.1},
  {"code": "3", "name": "window", "kind": "disc", "size_m": 0.12}]})";

struct WallKind {
  std::string name;
  double wave_m, pitch_m, brightness, texture;
  double lift_m = 0.005;
  bool has_joints = false;  ///< dark lines every 30 cm, as between tiles
};

/// Kinds that constants were chosen with, and others that were only reported.
inline const std::vector<WallKind> kDevelopedWalls{{"plaster", 0, 0.2, 0.5, 0.03},
                                                   {"corrugated", 0.025, 0.2, 0.5, 0.02}};
inline const std::vector<WallKind> kReportedWalls{{"white plaster", 0, 0.2, 0.85, 0.05},
                                                  {"dark sheet", 0.015, 0.1, 0.15, 0.02},
                                                  {"deep sheet", 0.04, 0.3, 0.6, 0.03}};

inline Sheet poster(double u_m, double v_m, RandomStream& random) {
  const uint64_t key = random.bits();
  const double block = 0.04 + 0.08 * random.uniform();
  return {u_m, v_m, 0, 0.24, 0.004, [key, block](double x, double y) {
            const auto i = static_cast<uint64_t>(std::floor(x / block) + 64),
                       k = static_cast<uint64_t>(std::floor(y / block) + 64);
            return RandomStream(key, 128 * i + k).uniform();
          }};
}
inline Sheet tiles(double u_m, double v_m, double tile_m) {
  return {u_m, v_m, 0, 0.25, 0.004, [tile_m](double x, double y) {
            const double i = std::floor(x / tile_m) + std::floor(y / tile_m);
            return std::fmod(std::fabs(i), 2) < 0.5 ? 0.9 : 0.1;
          }};
}
inline Sheet window(double u_m, double v_m) {
  return {u_m, v_m, 0, 0.25, 0.004, [](double x, double y) {
            const bool is_frame = std::max(std::fabs(x), std::fabs(y)) > 0.21 ||
                                  std::min(std::fabs(x), std::fabs(y)) < 0.025;
            return is_frame ? 0.9 : 0.12;
          }};
}
inline Sheet dark_square(double u_m, double v_m, double size_m) {
  return {u_m, v_m, 0.3, 0.15, 0.004, [size_m](double x, double y) {
            return std::max(std::fabs(x), std::fabs(y)) < size_m / 2 ? 0.08 : 0.9;
          }};
}
inline Sheet triangle_sign(double u_m, double v_m) {
  return {u_m, v_m, 0, 0.12, 0.004, [](double x, double y) {
            return y > -0.06 && std::fabs(x) < (0.09 - y) * 0.55 ? 0.15 : 0.9;
          }};
}
inline Sheet stripes(double u_m, double v_m, double stripe_m) {
  return {u_m, v_m, 0.4, 0.15, 0.004, [stripe_m](double x, double) {
            return std::fmod(std::fabs(x / stripe_m), 2) < 1 ? 0.1 : 0.9;
          }};
}

/// Distance, spacing and slant by dice: 3 to 30 m, 3 to 15 mm, up to 60 degrees.
inline TargetWall any_wall(const WallKind& kind, uint64_t seed) {
  RandomStream random(seed, 31);
  TargetWall wall;
  wall.width_m = 4, wall.height_m = 2.2;
  wall.wave_m = kind.wave_m, wall.pitch_m = kind.pitch_m;
  wall.wall_brightness = kind.brightness, wall.wall_texture = kind.texture;
  wall.distance_m = 3 * std::pow(10, random.uniform());
  wall.spacing_m = 0.003 * std::pow(5, random.uniform());
  wall.oblique_rad = std::numbers::pi / 3 * random.uniform();
  wall.brightness_noise = 0.02 + 0.12 * random.uniform();
  constexpr double kSpot_m = 0.003, kDivergence_rad = 0.0003;
  wall.spot_m = kSpot_m + kDivergence_rad * wall.distance_m;
  const auto turn = [&] { return 2 * std::numbers::pi * random.uniform(); };
  const auto off = [&] { return 0.06 * (random.uniform() - 0.5); };
  const double low = 0.5, high = 1.6;
  wall.sheets = {checker_sheet(0.35 + off(), low + off(), turn(), 0.15, 0.01 * random.uniform()),
                 checker_sheet(0.35 + off(), high + off(), 0, 0.15),
                 checker_sheet(1.0 + off(), low + off(), turn(), 0.1),
                 checker_sheet(1.0 + off(), high + off(), turn(), 0.1, 0.01),
                 disc_sheet(1.6 + off(), low + off(), 0.12),
                 disc_sheet(1.6 + off(), high + off(), 0.12, true),
                 checker_sheet(2.1 + off(), low + off(), turn(), 0.125),
                 disc_sheet(2.1 + off(), high + off(), 0.16)};
  for (Sheet& s : wall.sheets) s.lift_m = kind.lift_m;
  const double size = 0.09 + 0.07 * random.uniform();
  const std::vector<Sheet> others{poster(2.6, low, random),       poster(2.6, high, random),
                                  tiles(3.1, low, size),          window(3.1, high),
                                  dark_square(3.55, low, size),   triangle_sign(3.6, high),
                                  stripes(3.75, 1.05, 0.3 * size)};
  wall.sheets.insert(wall.sheets.end(), others.begin(), others.end());
  return wall;
}

}  // namespace jalon::test
