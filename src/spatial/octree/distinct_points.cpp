// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/octree/distinct_points.h"

#include <algorithm>

#include "base/parallel.h"
#include "spatial/octree/impl.h"

namespace jalon {

namespace {

// Fewer than that many leaves of repeated points cost less than a second tree.
constexpr size_t kFewLeaves = 16;

bool one_node(const BoxBlock& block, size_t slot) {
  for (int axis = 0; axis < 3; ++axis)
    if (block.lo[axis][slot] != block.hi[axis][slot]) return false;
  return true;
}

// All points of the leaf equal the first of the leaf before.
bool repeats(const Octree::Impl& tree, size_t leaf) {
  const BoxBlock &here = tree.levels[0][leaf / kBoxes],
                 &before = tree.levels[0][(leaf - 1) / kBoxes];
  const size_t slot = leaf % kBoxes, slot_before = (leaf - 1) % kBoxes;
  if (!one_node(here, slot) || !one_node(before, slot_before)) return false;
  const Vec3 first = tree.exact_point(tree.leaf_first[leaf - 1]);
  for (size_t i = tree.leaf_first[leaf]; i < tree.leaf_first[leaf + 1]; ++i)
    if (!(tree.exact_point(i) == first)) return false;
  return true;
}

}  // namespace

DistinctPoints::DistinctPoints(const Octree& all, Task& task) : all_(all) {
  const std::vector<uint32_t> leaves = repeating_leaves(task);
  if (leaves.size() > kFewLeaves) thin(leaves, task);
}

std::vector<uint32_t> DistinctPoints::repeating_leaves(Task& task) const {
  const Octree::Impl& tree = all_.impl();
  constexpr size_t kGrain = size_t{1} << 13;
  std::vector<std::vector<uint32_t>> parts((tree.leaves + kGrain - 1) / kGrain);
  parallel_for(task, tree.leaves, kGrain, [&](size_t begin, size_t end) {
    for (size_t leaf = std::max<size_t>(1, begin); leaf < end; ++leaf)
      if (repeats(tree, leaf)) parts[begin / kGrain].push_back(static_cast<uint32_t>(leaf));
  });
  std::vector<uint32_t> leaves;
  for (const auto& part : parts) leaves.insert(leaves.end(), part.begin(), part.end());
  return leaves;
}

// The caller's order is kept, so that the smallest index stays the smallest; points of one code stand by index, so what
// is left of a run is its first.
void DistinctPoints::thin(const std::vector<uint32_t>& leaves, Task& task) {
  const Octree::Impl& tree = all_.impl();
  std::vector<uint32_t> position(tree.count);
  for (size_t p = 0; p < tree.count; ++p) position[tree.order[p]] = static_cast<uint32_t>(p);
  size_t kept = tree.count;
  for (const uint32_t leaf : leaves) {
    for (size_t p = tree.leaf_first[leaf]; p < tree.leaf_first[leaf + 1]; ++p)
      position[tree.order[p]] = kNoPoint;
    kept -= tree.leaf_first[leaf + 1] - tree.leaf_first[leaf];
  }
  task.checkpoint(0);
  xyz_ = Buffer<double>(3 * kept);
  position_of_ = Buffer<uint32_t>(kept);
  size_t to = 0;
  for (size_t i = 0; i < tree.count; ++i) {
    if (position[i] == kNoPoint) continue;
    std::copy_n(tree.xyz.data() + 3 * i, 3, xyz_.data() + 3 * to);
    position_of_[to++] = position[i];
  }
  thinned_ = Octree::build({xyz_.data(), xyz_.size()}, tree.cube, task);
}

}  // namespace jalon
