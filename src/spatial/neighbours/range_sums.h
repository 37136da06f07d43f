// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "spatial/octree/impl.h"
#include "spatial/octree/octree.h"
#include "spatial/power_sums.h"

namespace jalon {

/// The grid coordinates of a sorted position.
inline Vec3 grid_place(const Octree& tree, size_t position) {
  return tree.impl().grid_point(position);
}

/// The caller's coordinates, in metres: where the grid does not tell points apart.
inline Vec3 exact_place(const Octree& tree, size_t position) {
  return tree.impl().exact_point(position);
}

/// Power sums of the grid coordinates (or of other places) of ranges of a tree's sorted positions, by a tree of blocks
/// over them: a range costs O(log n). About 10 bits a point for planes, 40 for quadrics. The same bits for any number
/// of threads.
template <int Degree, Vec3 (*place_of)(const Octree&, size_t) = grid_place>
class RangeSums {
 public:
  /// The octree must outlive it.
  RangeSums(const Octree& tree, Task& task) : tree_(tree), size_(tree.size()) {
    size_t blocks = (size_ + kBlock - 1) / kBlock;
    for (size_t level = 0; blocks > 0; ++level, blocks = (blocks + kFan - 1) / kFan) {
      levels_.emplace_back(blocks);
      parallel_for(task, blocks, kBlocksAtOnce, [&](size_t begin, size_t end) {
        for (size_t k = begin; k < end; ++k) fill(level, k);
      });
      if (blocks == 1) break;
    }
  }

  /// As seen from a place.
  PowerSums<Degree> over(std::span<const Octree::PointRange> ranges, const Vec3& from) const {
    PowerSums<Degree> out;
    for (const Octree::PointRange& range : ranges) add(range.first, range.last, from, out);
    return out;
  }

 private:
  static constexpr size_t kBlock = 64, kFan = 8;
  static constexpr size_t kBlocksAtOnce = 256;

  // Where the block is seen from: its first point.
  Vec3 origin_of(size_t level, size_t block) const {
    return place_of(tree_, block * kBlock << 3 * level);
  }

  void fill(size_t level, size_t block) {
    PowerSums<Degree>& out = levels_[level][block];
    const Vec3 from = origin_of(level, block);
    if (level == 0)
      return add_points(block * kBlock, std::min(size_, (block + 1) * kBlock), from, out);
    const size_t last = std::min(levels_[level - 1].size(), (block + 1) * kFan);
    for (size_t k = block * kFan; k < last; ++k) add_block(level - 1, k, from, out);
  }
  void add_points(size_t first, size_t last, const Vec3& from, PowerSums<Degree>& out) const {
    for (size_t i = first; i < last; ++i) out.add(place_of(tree_, i) - from);
  }
  void add_block(size_t level, size_t block, const Vec3& from, PowerSums<Degree>& out) const {
    out += levels_[level][block].shifted(origin_of(level, block) - from);
  }
  void add(size_t first, size_t last, const Vec3& from, PowerSums<Degree>& out) const {
    size_t low = (first + kBlock - 1) / kBlock,
           high = last == size_ ? levels_[0].size() : last / kBlock;
    if (low >= high) return add_points(first, last, from, out);
    add_points(first, low * kBlock, from, out);
    add_points(std::min(last, high * kBlock), last, from, out);
    for (size_t level = 0; low < high; ++level, low /= kFan, high /= kFan) {
      const bool is_top = level + 1 == levels_.size();
      for (; low < high && (is_top || low % kFan != 0); ++low) add_block(level, low, from, out);
      for (; low < high && high % kFan != 0; --high) add_block(level, high - 1, from, out);
    }
  }

  const Octree& tree_;
  size_t size_;
  std::vector<std::vector<PowerSums<Degree>>> levels_;
};

}  // namespace jalon
