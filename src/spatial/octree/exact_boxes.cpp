// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Boxes in doubles beside those on the grid, for clouds in which the grid does not tell the points of many leaves
// apart: there, all of a crowd would be as near as its nearest point. And for clouds with very many points on one
// place: of equally near ones those of the smallest indices are asked for, which the boxes know.

#include <algorithm>
#include <limits>

#include "base/parallel.h"
#include "spatial/octree/impl.h"

namespace jalon {

namespace {

// Points in crowded leaves that are looked at one by one in less time than the boxes take.
constexpr size_t kFewCrowded = 1024;
constexpr size_t kExactBlockGrain = 512;  // blocks

constexpr double kInfinite = std::numeric_limits<double>::infinity();

void clear(ExactBlock& block, size_t slot) {
  for (int axis = 0; axis < 3; ++axis) {
    block.lo[axis][slot] = kInfinite;
    block.hi[axis][slot] = -kInfinite;
  }
  block.least_index[slot] = kNoPoint;
}

void set_run(const Octree::Impl& tree, size_t run, ExactBlock& block, size_t slot) {
  clear(block, slot);
  const size_t first = run * kExactRun;
  for (size_t i = first; i < std::min(tree.count, first + kExactRun); ++i) {
    const Vec3 p = tree.exact_point(i);
    for (int axis = 0; axis < 3; ++axis) {
      block.lo[axis][slot] = std::min(block.lo[axis][slot], p[axis]);
      block.hi[axis][slot] = std::max(block.hi[axis][slot], p[axis]);
    }
    block.least_index[slot] = std::min(block.least_index[slot], tree.order[i]);
  }
}

void set_union(const ExactBlock& child, ExactBlock& block, size_t slot) {
  for (int axis = 0; axis < 3; ++axis) {
    block.lo[axis][slot] = *std::min_element(child.lo[axis], child.lo[axis] + kBoxes);
    block.hi[axis][slot] = *std::max_element(child.hi[axis], child.hi[axis] + kBoxes);
  }
  block.least_index[slot] = *std::min_element(child.least_index, child.least_index + kBoxes);
}

// Blocks of which set(item, block, slot) sets the first items' places; the others are empty.
template <class Set>
Buffer<ExactBlock> blocks_of(size_t items, Task& task, Set set) {
  Buffer<ExactBlock> out((items + kBoxes - 1) / kBoxes);
  parallel_for(task, out.size(), kExactBlockGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin * kBoxes; i < end * kBoxes; ++i) {
      ExactBlock& block = out[i / kBoxes];
      if (i < items) set(i, block, i % kBoxes);
      else clear(block, i % kBoxes);
    }
  });
  return out;
}

}  // namespace

bool Octree::Impl::is_crowded(size_t leaf, int shift) const {
  const BoxBlock& block = levels[0][leaf / kBoxes];
  const size_t slot = leaf % kBoxes;
  for (int axis = 0; axis < 3; ++axis)
    if (int64_t{block.hi[axis][slot]} - block.lo[axis][slot] > kCrowdedSteps << shift) return false;
  for (size_t i = leaf_first[leaf] + 1; i < leaf_first[leaf + 1]; ++i)
    if (!(exact_point(i) == exact_point(leaf_first[leaf]))) return true;
  return false;
}

bool Octree::Impl::is_crowded_at(int shift, Task& task) const {
  struct Points {
    size_t count = 0;
    Points& operator+=(const Points& b) {
      count += b.count;
      return *this;
    }
  };
  constexpr size_t kGrain = size_t{1} << 14;  // leaves
  const Points crowded =
      parallel_reduce(task, leaves, kGrain, Points{}, [&](size_t begin, size_t end) {
        Points points;
        for (size_t leaf = begin; leaf < end; ++leaf)
          if (is_crowded(leaf, shift)) points.count += leaf_first[leaf + 1] - leaf_first[leaf];
        return points;
      });
  return crowded.count > kFewCrowded;
}

void Octree::Impl::build_exact_boxes(Task& task) {
  if (!has_pile() && (on_grid || !is_crowded_at(0, task))) return;
  const size_t runs = (count + kExactRun - 1) / kExactRun;
  exact_levels.push_back(blocks_of(runs, task, [&](size_t run, ExactBlock& block, size_t slot) {
    set_run(*this, run, block, slot);
  }));
  while (exact_levels.back().size() > 1) {
    const Buffer<ExactBlock>& below = exact_levels.back();
    exact_levels.push_back(
        blocks_of(below.size(), task, [&](size_t child, ExactBlock& block, size_t slot) {
          set_union(below[child], block, slot);
        }));
  }
}

}  // namespace jalon
