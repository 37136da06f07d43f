// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/sight_equations.h"

#include <cmath>
#include <numbers>

namespace jalon {

// s: level distance in the map; h: height difference; d = (dx, dy, h).
SightEquation sight_equation(SightKind kind, const Vec3& instrument, const Vec3& target,
                             const NetworkSettings& settings) {
  const Vec3 d = target - instrument;
  const double s = std::hypot(d.x, d.y), h = d.z;
  const Vec3 along = s > 0 ? Vec3{d.x / s, d.y / s, 0} : Vec3{};
  if (kind == SightKind::kDirection)
    return {std::atan2(d.x, d.y), s > 0 ? Vec3{along.y / s, -along.x / s, 0} : Vec3{}};
  if (kind == SightKind::kDistance) {
    const double level = s / settings.scale, length = std::hypot(level, h);
    if (!(length > 0)) return {};
    return {length, along * (level / settings.scale / length) + Vec3{0, 0, h / length}};
  }
  const double bend = (1 - settings.refraction) / settings.earth_radius_m;
  const double seen = h - bend * s * s / 2, squared = s * s + seen * seen;
  if (!(squared > 0)) return {};
  return {std::atan2(s, seen),
          along * ((seen + bend * s * s) / squared) + Vec3{0, 0, -s / squared}};
}

double within_half_turn(double v_rad) { return std::remainder(v_rad, 2 * std::numbers::pi); }

}  // namespace jalon
