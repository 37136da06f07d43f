// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spatial/octree/impl.h"

namespace jalon {

/// The points of a ball as ranges of sorted positions: of boxes that lie in the ball as a whole no point is looked at,
/// so that a ball with most of a crowd in it costs what its surface cuts. One a thread.
class BallRanges {
 public:
  BallRanges(const Octree::Impl& tree, double radius_m);

  using Range = Octree::PointRange;
  /// The points within the radius, closed, as few ranges, ascending. Valid until the next search.
  std::span<const Range> find(const Vec3& centre);
  /// How many points they hold.
  size_t points() const { return points_; }
  /// How many boxes and points the searches have looked at so far.
  uint64_t looked_at() const { return looked_at_; }

 private:
  template <class Levels, class FirstOf>
  void descend(const Levels& levels, const Vec3& centre, FirstOf first_of);
  void take(size_t first, size_t last);
  void scan(const Vec3& centre, size_t first, size_t last);

  const Octree::Impl& tree_;
  const double squared_m2_;
  double slack_m_ = 0;  // of a box on the grid
  std::vector<Range> ranges_;
  size_t points_ = 0;
  uint64_t looked_at_ = 0;
};

}  // namespace jalon
