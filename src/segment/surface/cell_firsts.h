// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// First sorted positions of the occupied cells of the levels coarse ... fine, a list a level, with the end of the last
/// cell behind each: 4 B a cell where Octree::cells takes 24. scratch: a byte a point, overwritten. O(n + cells).
std::vector<std::vector<uint32_t>> cell_firsts(const Octree& tree, int coarse, int fine,
                                               Buffer<uint8_t>& scratch, Task& task);

}  // namespace jalon
