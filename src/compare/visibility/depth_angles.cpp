// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/depth_angles.h"

namespace jalon {

void sight(std::span<const double> xyz, const Vec3& centre, const Transform& axes,
           SightingBlock& out) {
  double x[SightingBlock::kPoints], y[SightingBlock::kPoints], z[SightingBlock::kPoints];
  const size_t n = xyz.size() / 3;
  for (size_t i = 0; i < n; ++i) {
    const Vec3 p = axes.direction(Vec3{xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]} - centre);
    x[i] = p.x;
    y[i] = p.y;
    z[i] = p.z;
  }
  for (size_t i = 0; i < n; ++i) {
    const Sighting s = sighting_of({x[i], y[i], z[i]});
    out.horizontal_rad[i] = s.horizontal_rad;
    out.vertical_rad[i] = s.vertical_rad;
    out.range_m[i] = s.range_m;
  }
}

}  // namespace jalon
