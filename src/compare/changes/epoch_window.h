// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/changes/change_objects.h"
#include "spatial/voxels/voxel_flood.h"

namespace jalon {

/// The points of an epoch in a window around a change, and the pieces that hang together among them. The epoch outlives
/// it. What a window costs goes by the points in it, whatever is asked for there.
class EpochWindow {
 public:
  explicit EpochWindow(const Epoch& epoch);

  /// The points in a local box; pieces are forgotten.
  void look(const Box3& box, Task& task);
  /// f(local place) of those that did not change, in the order of the cloud.
  template <class F>
  void for_each_unchanged(F&& f) const {
    for (const uint32_t i : points_)
      if (is_unchanged(i)) f(epoch_.local(i));
  }
  /// Pieces of what no support holds; none is taken. On one thread.
  void part(const std::vector<Support>& supports, double cell_m, Task& task);

  /// Takes the piece of a point of the cloud; of one outside the window or on a support there is none.
  void take(uint32_t i);
  /// Takes the pieces of the points of the other epoch that lie nearest to the unchanged ones of this one, of pieces
  /// that were taken since it was last asked. Returns whether there were any.
  bool take_counterparts(EpochWindow& other);
  /// The points of all pieces whose counterparts were taken, ascending.
  std::vector<uint32_t> whole() const;

 private:
  bool is_unchanged(uint32_t i) const {
    return statuses_[i] == static_cast<uint8_t>(CompareStatus::kCompared) &&
           epoch_.regions.changed[i] == 0;
  }

  const Epoch& epoch_;
  std::span<const uint8_t> statuses_;
  std::span<const uint32_t> nearests_;
  std::vector<uint32_t> points_;     ///< of the cloud, ascending
  std::vector<uint64_t> is_inside_;  ///< one bit a point of the cloud
  std::vector<uint32_t> rank_;       ///< points inside before each 64 of the cloud
  std::vector<uint32_t> voxels_;     ///< of pieces_, of each point; kHeld: on a support
  VoxelFlood pieces_{1};
};

}  // namespace jalon
