// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Inside of the triangle tree: nodes and their construction.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon::triangle_tree {

using Float4 [[gnu::vector_size(16)]] = float;

/// Boxes in floats, as the nodes hold them.
struct FloatBox {
  float min[3] = {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
                  std::numeric_limits<float>::infinity()};
  float max[3] = {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
                  -std::numeric_limits<float>::infinity()};

  void add(const FloatBox& b) {
    for (int i = 0; i < 3; ++i) {
      min[i] = b.min[i] < min[i] ? b.min[i] : min[i];
      max[i] = b.max[i] > max[i] ? b.max[i] : max[i];
    }
  }
  /// Half the surface; 0 for an empty box.
  float half_area() const {
    const float x = max[0] - min[0], y = max[1] - min[1], z = max[2] - min[2];
    return x >= 0 ? x * y + y * z + z * x : 0;
  }
};

constexpr uint32_t kWidth = 4;
/// Triangles in a leaf of rays at most: measured on the scenes, 2 beats 4 by a fifth and 1 and 8 by more.
constexpr uint32_t kLeafSize = 2;
/// Nodes deeper than this split by count, which halves the largest part at each level: the stack of a query is
/// bounded.
constexpr int kMaxBinnedDepth = 40;
constexpr size_t kStackSize = (kMaxBinnedDepth + 32 + 2) * (kWidth - 1);

/// Four children: bounds as rows min x, max x, min y ...; count 0 = inner node (child is its index), else a leaf with
/// the triangles [child, child + count) in tree order. Unused children have an empty box.
struct alignas(64) Node {
  Float4 bounds[6];
  uint32_t child[kWidth];
  uint32_t count[kWidth];
};

struct Nodes {
  std::vector<Node> nodes;      ///< the root first; none for an empty tree
  std::vector<uint32_t> order;  ///< tree order -> triangle
};

/// Top-down, splits by the binned surface area heuristic (Wald 2007). Depends on the boxes only, not on the threads.
/// Leaves hold leaf_size triangles at most; a split counts the tests of at_once triangles each, so that leaves of lanes
/// come out full (Wald, Benthin & Boulos 2008, Getting rid of packets).
Nodes build_nodes(std::span<const FloatBox> boxes, uint32_t leaf_size, uint32_t at_once,
                  Task& task);

}  // namespace jalon::triangle_tree
