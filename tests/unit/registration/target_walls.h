// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "cloud/cloud.h"
#include "registration/targets/measure.h"

namespace jalon::test {

/// A flat sheet stuck on a wall, in the wall's own axes: brightness of what is printed on it, 0 ... 1.
struct Sheet {
  double u_m = 0, v_m = 0, turn_rad = 0, half_m = 0.05;
  double lift_m = 0.005;  ///< before the foremost of the wall
  std::function<double(double, double)> print;
  TargetKind kind = TargetKind::kPatch;  ///< kChecker, kDisc: a target; kPatch: something else
  double size_m = 0;
};

/// One wall and a scanner before it, which sees sheets, wall and nothing else.
struct TargetWall {
  double width_m = 8, height_m = 3;
  double wave_m = 0, pitch_m = 0.2;  ///< corrugation: amplitude and pitch
  double distance_m = 6, oblique_rad = 0;
  double spacing_m = 0.005;  ///< of the points on a wall that faces the scanner, at the distance
  double range_noise_m = 0.0015, brightness_noise = 0.06;
  double spot_m = 0.003;  ///< diameter over which brightness is averaged
  double wall_brightness = 0.5, wall_texture = 0.03;
  std::vector<Sheet> sheets;
};

inline Sheet checker_sheet(double u_m, double v_m, double turn_rad, double size_m,
                           double margin_m = 0) {
  const double h = size_m / 2;
  return {u_m,
          v_m,
          turn_rad,
          h + margin_m,
          0.005,
          [h](double x, double y) {
            if (std::max(std::fabs(x), std::fabs(y)) > h) return 0.95;
            return (x > 0) == (y > 0) ? 0.9 : 0.08;
          },
          TargetKind::kChecker,
          size_m};
}

inline Sheet disc_sheet(double u_m, double v_m, double size_m, bool is_bright = false) {
  const double r = size_m / 2;
  return {u_m,
          v_m,
          0,
          0.85 * size_m,
          0.005,
          [r, is_bright](double x, double y) {
            return (std::hypot(x, y) < r) == is_bright ? 0.9 : 0.08;
          },
          TargetKind::kDisc,
          size_m};
}

/// Where its centre lies, x along the wall, y away from the scanner, z up.
inline Vec3 place_of(const TargetWall& wall, const Sheet& sheet) {
  return {sheet.u_m, -(wall.wave_m + sheet.lift_m), sheet.v_m};
}

/// Beams at equal angles; the brightness of a spot is the mean of five places in it, weaker where the wall is seen
/// askew, with its noise; "intensity" of 16 bits.
inline Cloud scan_of(const TargetWall& wall, uint64_t seed, bool has_intensity = true) {
  RandomStream random(seed, 0);
  const Vec3 eye{wall.width_m / 2 + wall.distance_m * std::sin(wall.oblique_rad),
                 -wall.distance_m * std::cos(wall.oblique_rad), wall.height_m / 2};
  const double step = wall.spacing_m / wall.distance_m;
  const double from = std::atan2(-eye.x, -eye.y), to = std::atan2(wall.width_m - eye.x, -eye.y);
  const double high = std::atan2(wall.height_m / 2, wall.distance_m * 0.5);
  const double wave = 2 * std::numbers::pi / wall.pitch_m;
  const double texture_u = 3 + 2 * random.uniform(), texture_v = 4 + 2 * random.uniform();
  std::vector<double> xyz;
  std::vector<uint16_t> intensity;
  for (double a = from + step * random.uniform(); a < to; a += step)
    for (double e = -high; e < high; e += step) {
      const Vec3 ray{std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
      double range = 0, brightness = 0;
      bool is_hit = false;
      for (const Sheet& s : wall.sheets) {
        const double t = (-(wall.wave_m + s.lift_m) - eye.y) / ray.y;
        const Vec3 p = eye + t * ray;
        const double c = std::cos(s.turn_rad), si = std::sin(s.turn_rad);
        const auto on = [&](double du, double dv) {
          const double x = p.x - s.u_m + du, z = p.z - s.v_m + dv;
          return Vec2{c * x + si * z, c * z - si * x};
        };
        const Vec2 at = on(0, 0);
        if (std::max(std::fabs(at.u), std::fabs(at.v)) > s.half_m) continue;
        range = t, is_hit = true;
        const double d = wall.spot_m / 3;
        for (const Vec2& o : {Vec2{0, 0}, Vec2{d, 0}, Vec2{-d, 0}, Vec2{0, d}, Vec2{0, -d}}) {
          const Vec2 q = on(o.u, o.v);
          brightness += s.print(q.u, q.v) / 5;
        }
        break;
      }
      if (!is_hit) {
        double t = -eye.y / ray.y;
        for (int i = 0; i < 8; ++i)
          t = (-wall.wave_m * std::sin(wave * (eye.x + t * ray.x)) - eye.y) / ray.y;
        range = t;
        const Vec3 p = eye + t * ray;
        brightness = wall.wall_brightness +
                     wall.wall_texture * std::sin(texture_u * p.x) * std::cos(texture_v * p.z);
      }
      const Vec3 true_hit = eye + range * ray;
      if (true_hit.x < 0 || true_hit.x > wall.width_m || true_hit.z < 0 ||
          true_hit.z > wall.height_m)
        continue;
      const Vec3 p = true_hit + wall.range_noise_m * random.normal() * ray;
      xyz.insert(xyz.end(), {p.x, p.y, p.z});
      const double seen = brightness * std::max(0.3, std::fabs(ray.y)) +
                          wall.brightness_noise * 0.5 * random.normal();
      intensity.push_back(static_cast<uint16_t>(std::clamp(20000 + 30000 * seen, 0.0, 65535.0)));
    }
  Buffer<double> buffer(xyz.size());
  std::copy(xyz.begin(), xyz.end(), buffer.begin());
  Cloud out = make_cloud(std::move(buffer));
  if (has_intensity) out.fields.set(make_column<uint16_t>({.name = "intensity"}, intensity));
  return out;
}

}  // namespace jalon::test
