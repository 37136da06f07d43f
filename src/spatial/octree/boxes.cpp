// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Tight boxes of the leaves and the tree above them.

#include <algorithm>
#include <limits>

#include "base/parallel.h"
#include "spatial/octree/impl.h"

namespace jalon {

namespace {

constexpr int32_t kHigh = std::numeric_limits<int32_t>::max(),
                  kLow = std::numeric_limits<int32_t>::min();

void clear(BoxBlock& block, size_t slot) {
  for (int axis = 0; axis < 3; ++axis) {
    block.lo[axis][slot] = kHigh;
    block.hi[axis][slot] = kLow;
  }
}

}  // namespace

void Octree::Impl::build_boxes(Task& task) {
  constexpr size_t kGrain = 512;  // blocks
  size_t blocks = (leaves + kBoxes - 1) / kBoxes;
  Buffer<BoxBlock> base(blocks);
  const int32_t* axes[3] = {x.data(), y.data(), z.data()};
  parallel_for(task, blocks, kGrain, [&](size_t begin, size_t end) {
    for (size_t leaf = begin * kBoxes; leaf < end * kBoxes; ++leaf) {
      BoxBlock& block = base[leaf / kBoxes];
      const size_t slot = leaf % kBoxes;
      if (leaf >= leaves) {
        clear(block, slot);
        continue;
      }
      const size_t first = leaf_first[leaf], last = leaf_first[leaf + 1];
      for (int axis = 0; axis < 3; ++axis) {
        const auto [lo, hi] = std::minmax_element(axes[axis] + first, axes[axis] + last);
        block.lo[axis][slot] = *lo;
        block.hi[axis][slot] = *hi;
      }
    }
  });
  levels.push_back(std::move(base));
  while (blocks > 1) {
    const Buffer<BoxBlock>& below = levels.back();
    const size_t children = blocks;
    blocks = (children + kBoxes - 1) / kBoxes;
    Buffer<BoxBlock> above(blocks);
    for (size_t child = 0; child < blocks * kBoxes; ++child) {
      BoxBlock& block = above[child / kBoxes];
      const size_t slot = child % kBoxes;
      clear(block, slot);
      if (child >= children) continue;
      for (int axis = 0; axis < 3; ++axis) {
        block.lo[axis][slot] =
            *std::min_element(below[child].lo[axis], below[child].lo[axis] + kBoxes);
        block.hi[axis][slot] =
            *std::max_element(below[child].hi[axis], below[child].hi[axis] + kBoxes);
      }
    }
    levels.push_back(std::move(above));
  }
  view = {x.data(), y.data(), z.data(), leaf_first.data(), {}, static_cast<int>(levels.size()) - 1};
  for (size_t i = 0; i < levels.size(); ++i) view.blocks[i] = levels[i].data();
}

}  // namespace jalon
