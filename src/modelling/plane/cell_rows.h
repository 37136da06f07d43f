// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// Points sorted into the square cells of a sparse raster, row by row. Memory follows the points, not the area.
struct CellRows {
  double cell_m = 1;
  Vec2 corner;
  std::vector<uint64_t>
      keys;  ///< of the occupied cells, ascending: row << 32 | column, both from 1
  std::vector<uint32_t> first;  ///< keys.size() + 1; cell c holds order[first[c] ... first[c + 1])
  std::vector<uint32_t> order;  ///< point indices by cell, ascending within one

  uint64_t key_of(const Vec2& p) const;
  /// First cell whose key is not below this, or keys.size().
  size_t lower(uint64_t key) const {
    return static_cast<size_t>(std::lower_bound(keys.begin(), keys.end(), key) - keys.begin());
  }
  /// Cell of that key, or keys.size().
  size_t find(uint64_t key) const;
};

/// Before: points not empty, finite; cell_m above 0. After: every point is in one cell; cell_m is
/// enlarged where rows or columns would not fit 31 bits. O(n log n).
CellRows sort_into_cells(std::span<const Vec2> points, double cell_m, Task& task);

/// 1 for marked cells whose eight neighbours are all marked. marked: one a cell, as the result.
/// O(cells).
std::vector<uint8_t> eroded(const CellRows& rows, std::span<const uint8_t> marked);

/// Points that are looked up by boxes.
struct PointRows {
  std::vector<Vec2> points;
  CellRows rows;

  void sort(double cell_m, Task& task) {
    if (!points.empty()) rows = sort_into_cells(points, cell_m, task);
  }
  /// f(i) for the points of all cells that meet the box.
  template <class F>
  void visit(const Vec2& low, const Vec2& high, F&& f) const {
    if (points.empty()) return;
    const uint64_t left = number_of(low.u - rows.corner.u),
                   right = number_of(high.u - rows.corner.u);
    const uint64_t top = number_of(high.v - rows.corner.v);
    for (uint64_t row = number_of(low.v - rows.corner.v); row <= top; ++row) {
      size_t c = rows.lower(row << 32 | left);
      for (const uint64_t end = row << 32 | right; c < rows.keys.size() && rows.keys[c] <= end; ++c)
        for (uint32_t k = rows.first[c]; k < rows.first[c + 1]; ++k) f(rows.order[k]);
    }
  }

 private:
  uint64_t number_of(double offset_m) const {
    constexpr double kMost = 0x1p31 - 2;
    const double cell = offset_m / rows.cell_m;
    return cell < 0 ? 0 : static_cast<uint64_t>(cell < kMost ? cell : kMost) + 1;
  }
};

}  // namespace jalon
