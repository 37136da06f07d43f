// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segment/segmentation.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Tells the points of a plane that are as much another plane's, which crosses it there and on which it ends: a soffit
/// that runs over the tops of posts to the wall behind leaves a row of its points in the plane of the posts, between
/// them and beside them. Such points bound nothing; where the plane ends the joint with the other one tells.
class CrossingPoints {
 public:
  /// Before: segment is the index of a plane in segmentation.segments; tree is that of its cloud.
  /// boxes: of the points of each segment. The arguments but these must outlive it. O(segments).
  CrossingPoints(const Segmentation& segmentation, const Octree& tree, size_t segment,
                 std::span<const Box3> boxes);

  /// Whether a plane that is not parallel to this one goes through the point, with points of its own before and behind
  /// this plane within reach_m, while this plane has no points on both sides of that one. O(planes), and O(points
  /// within reach) where it lies on one of them.
  bool holds(uint32_t point, double reach_m) const;

 private:
  /// The planes that cross this one, a coordinate each, and how near to them a point may lie on them.
  struct Crossing {
    std::vector<double> x, y, z, offset, reach_m;
    std::vector<Box3> box;
  };
  bool lies_on_one(const Vec3& p) const;
  bool has_one_near(const Vec3& p, double reach_m) const;
  bool ends_at(const Segment& other, const Vec3& p, const std::vector<Neighbour>& near) const;

  const Segmentation& segmentation_;
  const Octree& tree_;
  const Segment& own_;
  std::vector<uint8_t> crosses_;  ///< by label: a plane that is not parallel to this one
  Crossing crossing_;
};

}  // namespace jalon
