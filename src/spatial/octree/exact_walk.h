// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "spatial/octree/impl.h"

namespace jalon {

/// The squared distance of a box from a place, rounded as squared_norm(point - q) is, step by step, so that it never
/// exceeds that of a point in the box.
inline double squared_distance(const ExactBlock& block, size_t slot, const Vec3& q) {
  Vec3 out;
  for (int axis = 0; axis < 3; ++axis)
    out[axis] = std::max({block.lo[axis][slot] - q[axis], q[axis] - block.hi[axis][slot], 0.0});
  return squared_norm(out);
}

template <class Scan>
void scan_run(const Octree::Impl& tree, size_t run, Scan scan) {
  const size_t first = run * kExactRun;
  scan(first, std::min(tree.count, first + kExactRun));
}

/// Depth-first through the boxes in doubles of a tree that has them, the nearest box first, of equally near ones that
/// of the smallest index: may_hold(squared, least_index) says whether a box is opened, scan(first, last) looks at the
/// sorted points of one.
template <class MayHold, class Scan>
void exact_walk(const Octree::Impl& tree, const Vec3& q, MayHold may_hold, Scan scan) {
  struct Visit {
    double squared;
    uint32_t least_index, level, block;
    bool operator<(const Visit& b) const {
      return squared < b.squared || (squared == b.squared && least_index < b.least_index);
    }
  };
  if (tree.count == 0) return;
  Visit stack[kBoxes * 12];  // 7 siblings wait on each of at most 11 levels
  size_t depth = 0;
  stack[depth++] = {0, 0, static_cast<uint32_t>(tree.exact_levels.size()) - 1, 0};
  while (depth != 0) {
    const Visit visit = stack[--depth];
    if (!may_hold(visit.squared, visit.least_index)) continue;
    const ExactBlock& b = tree.exact_levels[visit.level][visit.block];
    Visit children[kBoxes];
    size_t count = 0;
    for (uint32_t i = 0; i < kBoxes; ++i) {
      if (b.least_index[i] == kNoPoint) continue;
      const Visit child{squared_distance(b, i, q), b.least_index[i], visit.level,
                        visit.block * static_cast<uint32_t>(kBoxes) + i};
      if (!may_hold(child.squared, child.least_index)) continue;
      size_t at = count++;
      for (; at > 0 && child < children[at - 1]; --at) children[at] = children[at - 1];
      children[at] = child;
    }
    if (visit.level == 0) {
      for (size_t i = 0; i < count; ++i)
        if (may_hold(children[i].squared, children[i].least_index))
          scan_run(tree, children[i].block, scan);
    } else {
      for (size_t i = count; i-- > 0;) {
        stack[depth] = children[i];
        stack[depth++].level = visit.level - 1;
      }
    }
  }
}

/// Shapes of so few steps of the grid are looked for in the boxes in doubles: the grid does not tell which points of a
/// crowd are in.
constexpr double kFewSteps = 64;

/// Calls scan(first, last) in the order of the curve for the runs of points of which meets(block, slot) holds, and
/// held of all above.
template <class Meets, class Scan>
void exact_runs(const Octree::Impl& tree, Meets meets, Scan scan) {
  const auto descend = [&](const auto& self, size_t level, size_t number) -> void {
    const ExactBlock& block = tree.exact_levels[level][number];
    for (size_t slot = 0; slot < kBoxes; ++slot) {
      if (block.least_index[slot] == kNoPoint || !meets(block, slot)) continue;
      const size_t child = number * kBoxes + slot;
      if (level == 0) scan_run(tree, child, scan);
      else self(self, level - 1, child);
    }
  };
  if (tree.count != 0) descend(descend, tree.exact_levels.size() - 1, 0);
}

}  // namespace jalon
