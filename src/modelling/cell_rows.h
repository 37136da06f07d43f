// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// Points sorted into the square cells of a sparse raster, row by row. Memory follows the points, not the area.
struct CellRows {
  double cell_m = 1;
  Vec2 corner;
  std::vector<uint64_t> keys;    ///< of the occupied cells, ascending: row << 32 | column, both from 1
  std::vector<uint32_t> first;   ///< keys.size() + 1; cell c holds order[first[c] ... first[c + 1])
  std::vector<uint32_t> order;   ///< point indices by cell, ascending within one

  uint64_t key_of(const Vec2& p) const;
  /// Cell of that key, or keys.size().
  size_t find(uint64_t key) const;
};

/// cell_m is enlarged where rows or columns would not fit 31 bits. points: not empty, finite.
CellRows sort_into_cells(std::span<const Vec2> points, double cell_m);

/// 1 for marked cells whose eight neighbours are all marked. O(cells).
std::vector<uint8_t> eroded(const CellRows& rows, std::span<const uint8_t> marked);

}  // namespace jalon
