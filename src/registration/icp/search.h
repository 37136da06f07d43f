// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "base/buffer.h"
#include "base/task.h"
#include "registration/icp/clouds.h"

namespace jalon {

/// For each point of a level its nearest one of the other cloud: a position, or kNoPoint where none
/// is near. As long and in the order of the level's points of that side.
struct IcpNeighbours {
  Buffer<uint32_t> of_moving, of_reference;
};

/// Finds neighbours at one level; keeps what does not depend on the pose. Near an edge the nearest
/// point often lies around the corner: where its normal is more than an angle off, the nearest of
/// some more that is not.
///
/// Before: clouds and level outlive the search. After: neighbours lie within the distance asked
/// for; deterministic, ties by position. O(n log n) a call for n points of the level.
class IcpSearch {
 public:
  /// least_cosine: between the normals of neighbours; 0: any.
  IcpSearch(const IcpClouds& clouds, const IcpLevel& level, double least_cosine, Task& task);
  IcpNeighbours find(const Transform& T_reference_moving, double max_distance_m, Task& task) const;

 private:
  std::shared_ptr<const Octree> moved_tree(const Transform& T_reference_moving, Buffer<double>& xyz,
                                           Task& task) const;
  void turn_corners(const Octree& moved, const Transform& T_reference_moving, double max_distance_m,
                    IcpNeighbours& found, Task& task) const;
  uint32_t reference_position(uint32_t in_tree) const {
    const std::vector<uint32_t>& positions = level_.reference.positions;
    return positions.empty() ? in_tree : positions[tree_->order()[in_tree]];
  }
  const IcpClouds& clouds_;
  const IcpLevel& level_;
  double least_cosine_;
  Buffer<double> xyz_;  // of the reference's points at this level, where they are not all
  std::shared_ptr<const Octree> tree_;
};

}  // namespace jalon
