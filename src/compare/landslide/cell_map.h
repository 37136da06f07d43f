// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "compare/volumes/volume_grid.h"

namespace jalon {

/// f(cell) of the cells around one, itself left out: the eight, or those that share an edge.
template <class F>
void for_each_around(const VolumeGrid& grid, size_t cell, F&& f, bool only_edges = false) {
  const auto column = static_cast<int64_t>(cell % grid.columns),
             row = static_cast<int64_t>(cell / grid.columns);
  for (int64_t r = std::max<int64_t>(0, row - 1); r <= std::min<int64_t>(grid.rows - 1, row + 1);
       ++r)
    for (int64_t c = std::max<int64_t>(0, column - 1);
         c <= std::min<int64_t>(grid.columns - 1, column + 1); ++c) {
      if (r == row && c == column) continue;
      if (only_edges && r != row && c != column) continue;
      f(static_cast<size_t>(r) * grid.columns + static_cast<size_t>(c));
    }
}

}  // namespace jalon
