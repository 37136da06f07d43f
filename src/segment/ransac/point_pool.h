// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "segment/ransac/curved_kernel.h"
#include "segment/ransac/ransac_scene.h"

namespace jalon {

/// The free points in single precision, component by component, as disjoint random subsets of 1, 3, 12 and 48 parts
/// in 64 (Schnabel et al. 2007, 4.5.1): the union of the first k is a random subset of the whole. Blocks of
/// neighbours have a box, so that a surface looks only at blocks it passes through. 28 B a point.
class PointPool {
 public:
  static constexpr size_t kPieces = 4;

  PointPool() = default;
  /// Collects the points with owner 0.
  PointPool(const RansacScene& scene, Task& task);

  size_t free_points() const { return free_; }
  size_t built_points() const { return built_; }
  /// Free points of the pieces 0 ... last.
  size_t points_upto(size_t last) const;

  /// Inliers in one piece. Thread-safe.
  uint32_t count(size_t piece, const PlaneTest& test, Task& task) const {
    return count_of(piece, test, task);
  }
  uint32_t count(size_t piece, const CurvedTest& test, Task& task) const {
    return count_of(piece, test, task);
  }
  /// Slots of all inliers in the box, ascending.
  std::vector<uint32_t> collect(const PlaneTest& test, const Box3& box, Task& task) const;
  /// The same anywhere.
  std::vector<uint32_t> collect(const CurvedTest& test, Task& task) const;
  /// Slots hold a position each, or kNoPoint.
  size_t slots() const { return slots_; }
  uint32_t position(uint32_t slot) const { return positions_[slot]; }
  Vec3 point(uint32_t slot) const {
    return {values_[slot], values_[slots_ + slot], values_[2 * slots_ + slot]};
  }
  /// Slots ascending, of points that the pool has: they are free no more.
  void remove(std::span<const uint32_t> slots, Task& task);

 private:
  template <class Test>
  uint32_t count_of(size_t piece, const Test& test, Task& task) const;
  template <class Test>
  std::vector<uint32_t> slots_of(const Test& test, const Box3& box, Task& task) const;
  bool may_touch(size_t block, const PlaneTest& test) const;
  bool may_touch(size_t block, const CurvedTest& test) const;
  bool overlaps(size_t block, const Box3& box) const;
  uint32_t count_in_block(size_t block, const PlaneTest& test) const;
  uint32_t count_in_block(size_t block, const CurvedTest& test) const;
  /// Slots of the block's inliers in the box; returns how many.
  template <class Test>
  uint32_t write_inliers(size_t block, const Test& test, const Box3& box, uint32_t* out) const;
  PointColumns columns(size_t block) const;
  void share_out(const RansacScene& scene, Task& task);
  void fill_block(const SegmentScene& scene, size_t block);

  size_t free_ = 0, built_ = 0;
  bool avx2_ = false;
  std::array<size_t, kPieces + 1> first_block_{};
  std::array<size_t, kPieces> piece_free_{};
  Buffer<float> values_;        ///< six columns
  Buffer<uint32_t> positions_;  ///< kNoPoint fills up
  Buffer<float> boxes_;         ///< centre and half sides, 6 a block
  size_t slots_ = 0;
};

}  // namespace jalon
