// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "spatial/octree/impl.h"

namespace jalon {

/// A ball around the points of a box of the octree.
struct BoundingBall {
  Vec3 centre;
  double radius_m = 0;
};

namespace octree_walk {

/// Rounding of map coordinates: the ball's centre may be off by this much (1e-9 m at 1e7 m).
constexpr double kRounding_m = 1e-8;

inline BoundingBall ball_of(const Octree::Impl& tree, const BoxBlock& block, size_t slot) {
  Vec3 middle, half;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = block.lo[axis][slot], hi = block.hi[axis][slot] + 1.0;
    middle[axis] = (lo + hi) * 0.5 * tree.step;
    half[axis] = (hi - lo) * 0.5 * tree.step;
  }
  return {tree.cube.origin + middle, norm(half) + kRounding_m};
}

}  // namespace octree_walk

/// Depth-first through the tree of boxes: enter(ball, key) says whether a box is opened, and sets the key by which
/// boxes of one block are taken, the least first; points(first, last) gets the sorted positions of a leaf that was
/// entered.
template <class Enter, class Points>
void walk_octree(const Octree& octree, Enter&& enter, Points&& points) {
  const Octree::Impl& tree = octree.impl();
  if (tree.count == 0) return;
  struct Visit {
    double key;
    uint32_t level, block;
  };
  std::array<Visit, kBoxes * 12> stack;  // 7 siblings wait on each of at most 11 levels
  size_t depth = 0;
  stack[depth++] = {0, static_cast<uint32_t>(tree.levels.size()), 0};
  while (depth != 0) {
    const Visit visit = stack[--depth];
    if (visit.level == 0) {
      points(static_cast<size_t>(tree.leaf_first[visit.block]),
             static_cast<size_t>(tree.leaf_first[visit.block + 1]));
      continue;
    }
    const BoxBlock& block = tree.levels[visit.level - 1][visit.block];
    std::array<Visit, kBoxes> children;
    size_t count = 0;
    for (uint32_t i = 0; i < kBoxes; ++i) {
      if (block.lo[0][i] > block.hi[0][i]) continue;
      Visit child{0, visit.level - 1, visit.block * static_cast<uint32_t>(kBoxes) + i};
      if (!enter(octree_walk::ball_of(tree, block, i), child.key)) continue;
      size_t at = count++;
      for (; at > 0 && children[at - 1].key > child.key; --at) children[at] = children[at - 1];
      children[at] = child;
    }
    for (size_t i = count; i-- > 0;) stack[depth++] = children[i];
  }
}

}  // namespace jalon
