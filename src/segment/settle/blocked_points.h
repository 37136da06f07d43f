// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segment/surface/connectivity.h"

namespace jalon {

/// The projection of a box, no smaller than that of any point in it where slack_m is projection_slack_m().
FlatBox shadow_of(const Box3& box, const FlatFrame& frame, double slack_m);
double projection_slack_m(const SegmentScene& scene);

/// The points of a surface in short runs of neighbours, each with its box: what is far from another surface, most of a
/// large one, is passed over run by run. Positions stay where they are and must outlive it.
class BlockedPoints {
 public:
  struct Block {
    Box3 box;
    std::span<const uint32_t> positions;
  };

  BlockedPoints() = default;
  /// positions: ascending, and so along the octree's curve.
  BlockedPoints(const SegmentScene& scene, std::span<const uint32_t> positions, Task& task);
  void take(BlockedPoints&& other);

  /// Neighbouring blocks together, with their box.
  struct Group {
    Box3 box;
    size_t begin = 0, end = 0;  ///< in blocks()
  };

  std::span<const Block> blocks() const { return blocks_; }
  std::span<const Group> groups() const { return groups_; }
  uint32_t first_position() const { return first_; }
  size_t size() const { return size_; }

 private:
  std::vector<Block> blocks_;
  std::vector<Group> groups_;
  uint32_t first_ = kNoPoint;
  size_t size_ = 0;
};

/// True when at least `least` of the points of one surface lie on pixels of another's image, or no more than `reach`
/// pixels beside one. frame, pixel_m: of that image, which is bounded_raster() of its points with a margin of reach.
/// Only the part of it that the points may lie on is made.
bool lie_over(const SegmentScene& scene, const BlockedPoints& points, size_t least,
              const BlockedPoints& image, const FlatFrame& frame, double pixel_m, uint32_t reach);

}  // namespace jalon
