// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modelling/plane/vector_plane.h"
#include "modelling/walls/holes.h"

namespace jalon {

constexpr uint32_t kNoCell = ~uint32_t{0};
constexpr uint32_t kNoHole = ~uint32_t{0};

/// Cells over a wall and what lies in reach of it; which hole each is of.
struct WallRaster {
  Vec2 origin;
  double cell_m = 1;
  uint32_t columns = 0, rows = 0;
  std::vector<uint32_t> hole;  ///< kNoHole: none
  std::vector<uint32_t>
      near_hole;  ///< the same with a margin about each hole, and what lies below notches

  uint32_t cell_of(const Vec2& p) const {
    const double c = (p.u - origin.u) / cell_m, r = (p.v - origin.v) / cell_m;
    if (!(c >= 0 && r >= 0 && c < columns && r < rows)) return kNoCell;
    return static_cast<uint32_t>(r) * columns + static_cast<uint32_t>(c);
  }
  Vec2 centre(uint32_t column, uint32_t row) const {
    return {origin.u + (column + 0.5) * cell_m, origin.v + (row + 0.5) * cell_m};
  }
};

/// Cells of the wall's spacing, coarser where there would be too many. After: two cells of margin
/// all round at least; where holes overlap the later one has the cell. Empty for a wall without
/// faces.
WallRaster rasterise_wall(const VectorPlane& wall, std::span<const WallHole> holes);

}  // namespace jalon
