// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"
#include "spatial/neighbours/shape_kernel.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Points of a tree in balls and cylinders about many places, one after the other: it keeps its memory between them.
/// One a thread. Searches near each other are cheap: it takes a wider shape out of the tree than asked for and looks
/// there first (with the same answer, in the same order).
///
/// The grid and float vectors rule points out; who is in is settled in doubles between the caller's own coordinates,
/// relative to the centre, so that answers equal brute force and are the same wherever the cloud lies.
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
  std::span<const Along> cylinder(const Vec3& centre, const Vec3& axis, double radius_m,
                                  double half_length_m);

  /// Points of a cylinder that are as far along its axis, but for rounding.
  struct AlongRun {
    double along_m;
    uint32_t count;
  };
  /// cylinder() for a tree that has crowds: points of a box that lies in the cylinder as a whole, and across its axis,
  /// go together, so that a cylinder with most of a crowd in it costs what its surface cuts. In curve order.
  std::span<const AlongRun> cylinder_runs(const Vec3& centre, const Vec3& axis, double radius_m,
                                          double half_length_m);
  /// How many boxes and points cylinder_runs() has looked at so far.
  uint64_t looked_at() const { return looked_at_; }

  /// Sorted positions of what ball() gave last, in the same order.
  std::span<const uint32_t> ball_positions() const { return {candidates_.data(), offsets_.size()}; }

 private:
  struct Shape {
    Vec3 centre, axis;
    double radius_m = 0, half_length_m = 0;
    bool is_ball = true;
  };
  size_t search(const Shape& shape);
  size_t search_exactly(const Shape& shape);
  static bool covers(const Shape& wide, const Shape& shape);
  void take(const Shape& shape);
  GridShape grid_shape(const Shape& shape) const;

  const Octree& tree_;
  bool avx2_;
  bool taken_ = false;
  Shape wide_;  ///< whose points stand in taken_points_
  ShapePoints points_{};
  std::vector<int32_t> coordinates_;
  std::vector<uint32_t> positions_, candidates_;
  std::vector<Vec3> offsets_;
  std::vector<Along> along_;
  std::vector<AlongRun> runs_;
  uint64_t looked_at_ = 0;
};

}  // namespace jalon
