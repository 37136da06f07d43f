// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "spatial/neighbours/nearest_kernel.h"
#include "spatial/octree/impl.h"

namespace jalon {

/// The frame in which two trees are searched: its origin is the lower corner of both cubes, its step the smallest power
/// of two that puts both into [0, 2^31). A point lies within [0, 2) steps of its coordinates here: the grids round down
/// once, and so may the offsets of cubes that are not whole steps apart.
struct SearchFrame {
  double step = 1;
  GridMap reference, compared;

  SearchFrame(const Cube& r, const Cube& c) {
    const double r_step = std::ldexp(r.edge, -kGridBits), c_step = std::ldexp(c.edge, -kGridBits);
    Vec3 origin;
    double extent = 0;
    for (int i = 0; i < 3; ++i) {
      origin[i] = std::min(r.origin[i], c.origin[i]);
      extent = std::max(extent, std::max(r.origin[i] + r.edge, c.origin[i] + c.edge) - origin[i]);
    }
    step = std::max(r_step, c_step);
    while (extent / step > 0x1p31) step *= 2;
    reference = map_of(r, r_step, origin);
    compared = map_of(c, c_step, origin);
  }

 private:
  GridMap map_of(const Cube& cube, double grid_step, const Vec3& origin) const {
    constexpr int kAllBits = 31;  // more would shift out nothing more
    GridMap map;
    map.shift = std::min(kAllBits, std::ilogb(step) - std::ilogb(grid_step));
    for (int i = 0; i < 3; ++i)
      map.offset[i] = static_cast<int32_t>((cube.origin[i] - origin[i]) / step);
    return map;
  }
};

}  // namespace jalon
