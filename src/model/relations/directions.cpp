// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/directions.h"

namespace jalon {

ViewAxes axes_before(const Vec3& normal) {
  ViewAxes out;
  const Vec3 level = normalized({normal.x, normal.y, 0});
  if (!(norm(level) > 0)) return out;  // level planes are seen from above, Y up
  out.out = level;
  out.up = {0, 0, 1};
  out.right = cross(out.up, out.out);
  return out;
}

uint8_t directions(const Box3& from, const Box3& other, double tolerance) {
  uint8_t out = 0;
  for (int k = 0; k < 3; ++k) {
    const bool is_below = other.max[k] <= from.min[k] + tolerance,
               is_above = other.min[k] >= from.max[k] - tolerance;
    if (is_below == is_above) continue;  // two flat things in one plane are neither
    out = static_cast<uint8_t>(out | (is_below ? 1 : 2) << 2 * k);
  }
  return out;
}

}  // namespace jalon
