// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/octree/leaf_graph.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "spatial/octree/impl.h"

namespace jalon {

namespace {

static_assert(kMostLeafPoints == kLeafPoints);
constexpr size_t kMostNeighbours = 64;
constexpr size_t kLeavesPerChunk = 512;
constexpr int64_t kLastOfGrid = (int64_t{1} << kGridBits) - 1;

struct Window {
  int32_t lo[3], hi[3];

  bool meets(const BoxBlock& block, size_t slot) const {
    bool outside = false;
    for (int axis = 0; axis < 3; ++axis)
      outside |= block.lo[axis][slot] > hi[axis] || block.hi[axis][slot] < lo[axis];
    return !outside;
  }
};

// The box of a leaf, widened.
Window window_of(const OctreeView& view, size_t leaf, double reach) {
  const BoxBlock& block = view.blocks[0][leaf / kBoxes];
  const size_t slot = leaf % kBoxes;
  const auto margin = static_cast<int64_t>(std::min(reach, static_cast<double>(kLastOfGrid)));
  Window window;
  for (int axis = 0; axis < 3; ++axis) {
    window.lo[axis] = static_cast<int32_t>(std::max<int64_t>(0, block.lo[axis][slot] - margin));
    window.hi[axis] =
        static_cast<int32_t>(std::min<int64_t>(kLastOfGrid, block.hi[axis][slot] + margin));
  }
  return window;
}

// Depth first below one block, in the order of the curve, so that the leaves come out ascending.
void collect(const OctreeView& view, int level, size_t block, const Window& window, size_t self,
             size_t most, std::vector<uint32_t>& out) {
  const BoxBlock& boxes = view.blocks[level][block];
  for (size_t slot = 0; slot < kBoxes && out.size() < most; ++slot) {
    if (!window.meets(boxes, slot)) continue;
    const size_t child = block * kBoxes + slot;
    if (level > 0) collect(view, level - 1, child, window, self, most, out);
    else if (child != self) out.push_back(static_cast<uint32_t>(child));
  }
}

}  // namespace

std::span<const uint32_t> leaf_firsts(const Octree& tree) {
  return {tree.impl().leaf_first.data(), tree.impl().leaves + 1};
}

LeafGraph leaf_graph(const Octree& tree, std::span<const float> reach_m, Task& task) {
  const Octree::Impl& impl = tree.impl();
  const size_t leaves = impl.leaves;
  LeafGraph graph;
  graph.first.assign(leaves + 1, 0);
  std::vector<std::vector<uint32_t>> parts((leaves + kLeavesPerChunk - 1) / kLeavesPerChunk);
  parallel_for(task, leaves, kLeavesPerChunk, [&](size_t begin, size_t end) {
    std::vector<uint32_t>& part = parts[begin / kLeavesPerChunk];
    for (size_t leaf = begin; leaf < end; ++leaf) {
      const size_t before = part.size();
      if (reach_m[leaf] >= 0) {
        const Window window = window_of(impl.view, leaf, reach_m[leaf] * impl.inverse_step);
        collect(impl.view, impl.view.top, 0, window, leaf, before + kMostNeighbours, part);
      }
      graph.first[leaf + 1] = part.size() - before;
    }
  });
  for (size_t leaf = 0; leaf < leaves; ++leaf) graph.first[leaf + 1] += graph.first[leaf];
  graph.neighbours.resize(graph.first[leaves]);
  parallel_for(task, parts.size(), 8, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p)
      std::copy(
          parts[p].begin(), parts[p].end(),
          graph.neighbours.begin() + static_cast<ptrdiff_t>(graph.first[p * kLeavesPerChunk]));
  });
  return graph;
}

}  // namespace jalon
