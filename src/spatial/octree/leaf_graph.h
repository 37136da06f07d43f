// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

constexpr size_t kMostLeafPoints = 16;

/// The leaves of an octree: leaf i holds the sorted positions result[i] ... result[i + 1] - 1, at most kMostLeafPoints
/// points of one cell. The view lives as long as the tree.
std::span<const uint32_t> leaf_firsts(const Octree& tree);

/// Which leaves lie near each other, as adjacency lists one after the other.
struct LeafGraph {
  std::vector<size_t> first;  ///< leaves + 1
  std::vector<uint32_t>
      neighbours;  ///< of leaf i: neighbours[first[i]] ... neighbours[first[i + 1] - 1], ascending

  std::span<const uint32_t> of(size_t leaf) const {
    return {neighbours.data() + first[leaf], first[leaf + 1] - first[leaf]};
  }
};

/// Leaf k is a neighbour of leaf i when the tight boxes of their points come within reach_m[i] of each other on every
/// axis; a negative reach gives no neighbours, and no leaf gets more than 64 (piles of duplicates would have as many as
/// there are leaves of them). About 0.5 us a leaf; some 4 B a point of surface with a reach of two spacings.
LeafGraph leaf_graph(const Octree& tree, std::span<const float> reach_m, Task& task);

}  // namespace jalon
