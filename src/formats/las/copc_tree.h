// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "formats/las/copc.h"

namespace jalon::las {

/// A node's grid has 32 cells a side. With the 128 of EPT, PDAL and Untwine the nodes of the first
/// levels hold 200 000 points of walls and ground, which every box reads: a hundredth of 25 M points
/// took twice the time that it takes with 64, and with 32 it takes three quarters of that, while the
/// file is 2 to 4 % smaller, of scans of others too (more of the points are in nodes that are full).
constexpr int kCopcGridLevels = 5;

/// Points shared out among the nodes of an octree: those of the levels 0 to l together are a cloud in
/// which hardly any two stand closer than the spacing of level l. Every point is in one node, and lies
/// in its cell; a node is never empty, and its parent is there.
struct CopcTree {
  struct Node {
    CopcKey key;
    size_t first = 0, count = 0;  ///< in order
  };
  Vec3 centre;
  double halfsize = 1, spacing = 1;
  std::vector<uint32_t> order;  ///< the points node by node, along the curve of the octree
  std::vector<Node> nodes;      ///< level by level, along the curve
};

/// xyz: of n points, as the file will give them back. The cube stands on their lowest corner and has
/// the longest side of their box, as programs take it that look at the header alone (copclib). Each
/// node keeps the point nearest to the centre of each cell of its grid and hands the others
/// down; few are kept all. O(n log n), the same for any number of threads. Error(kLimit) above
/// 2^32 - 2 points.
CopcTree copc_tree(Buffer<double> xyz, Task& task);

}  // namespace jalon::las
