// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometry/vec.h"
#include "spatial/octree.h"

namespace jalon {

/// Points of a tree in balls and cylinders about many places, one after the other: it keeps its memory between them.
/// One a thread. The grid and float vectors rule points out; who is in is settled in doubles between the caller's own
/// coordinates, relative to the centre, so that answers equal brute force and are the same wherever the cloud lies.
class ShapeSearch {
 public:
  /// The tree must outlive it.
  explicit ShapeSearch(const Octree& tree);

  /// Offsets of the points within radius_m of the centre, closed, in curve order. Valid until the next search.
  std::span<const Vec3> ball(const Vec3& centre, double radius_m);

  /// One point of a cylinder.
  struct Along {
    double along_m;     ///< along the axis, from the centre
    uint32_t position;  ///< in the tree's order
  };
  /// Points at most radius_m from the axis through the centre and half_length_m from it along the axis (a unit vector),
  /// closed, in curve order. Valid until the next search.
  std::span<const Along> cylinder(const Vec3& centre, const Vec3& axis, double radius_m, double half_length_m);

  /// Sorted positions of what ball() gave last, in the same order.
  std::span<const uint32_t> ball_positions() const { return {candidates_.get(), offsets_.size()}; }

 private:
  size_t gather(const Vec3& centre, const Vec3* axis, double radius_m, double half_length_m);

  const Octree& tree_;
  bool avx2_;
  size_t capacity_ = 0;
  std::unique_ptr<uint32_t[]> candidates_;
  std::vector<Vec3> offsets_;
  std::vector<Along> along_;
};

}  // namespace jalon
