// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "cloud/cloud.h"

namespace jalon {

/// The points of one station where the scanner put them.
struct ScanGrid {
  uint32_t rows = 0, columns = 0;
  Buffer<uint32_t> points;  ///< sorted positions, row by row; kNoPoint: none

  uint32_t at(size_t row, size_t column) const { return points[row * columns + column]; }
};

/// Whether grids hold most of the points: by the fields "row" and "column", whose numbers must not lie so far apart
/// that a grid would be empty for the most part, as where a cloud was thinned.
bool is_organised(const Cloud& cloud, Task& task);

/// The grids of an organised cloud: one for each station, one of the whole cloud where it has none. In them are the
/// free points (owner 0); of several on one place, as of a beam with several returns, the first of the cloud.
std::vector<ScanGrid> scan_grids(const Cloud& cloud, const Octree& tree,
                                 std::span<const uint32_t> owner, Task& task);

}  // namespace jalon
