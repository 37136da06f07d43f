// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// A cell of the common cube with points of both clouds: ranges of sorted positions.
struct CellPair {
  uint64_t code;
  size_t reference_first, reference_count, compared_first, compared_count;
};

/// Occupied cells of a level, in code order. Meant for coarse levels: it leaps from cell to cell.
std::vector<Octree::Cell> occupied_cells(const Octree& tree, int level, Task& task);
/// The cells of a level that hold points of both; both trees on one cube.
std::vector<CellPair> homologous_cells(const Octree& reference, const Octree& compared, int level,
                                       Task& task);

}  // namespace jalon
