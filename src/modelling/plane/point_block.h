// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "cloud/cloud.h"
#include "geometry/vec.h"
#include "modelling/plane/plane_frame.h"

namespace jalon {

/// Between which numbers the places of points in a frame lie.
struct FrameBox {
  Vec2 low, high;
  double lowest = 0, highest = 0;  ///< heights above the plane
};

/// Some points of a cloud by coordinate, as they are asked against many planes: a block stays in the nearest caches and
/// its loops have no branch, which is what compilers turn into vector instructions.
/// The numbers are those of PlaneFrame, bit by bit.
class PointBlock {
 public:
  static constexpr size_t kMost = 256;  // 7 arrays of 2 KiB: frames stay below 16 KiB

  /// Points [begin, begin + count) of the cloud, at most kMost; or those that the order has there.
  void fill(const Cloud& cloud, std::span<const uint32_t> order, size_t begin, size_t count);
  size_t count() const { return count_; }
  /// Of the cloud.
  size_t index(size_t k) const { return index_[k]; }
  const Box3& box() const { return box_; }

  /// `height[k]`: of point k above the frame's plane.
  void heights(const PlaneFrame& frame, double* height) const;
  /// `u[k]`, `v[k]`: frame.project of point k.
  void project(const PlaneFrame& frame, double* u, double* v) const;
  /// Bounds of the three, by the block's box: a little wide.
  FrameBox bounds(const PlaneFrame& frame) const;

 private:
  size_t count_ = 0;
  Box3 box_;
  uint32_t index_[kMost];
  double x_[kMost], y_[kMost], z_[kMost];
};

}  // namespace jalon
