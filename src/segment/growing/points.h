// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "segment/growing_settings.h"
#include "segment/surface/scene.h"
#include "spatial/octree/leaf_graph.h"

namespace jalon {

/// What one round of growing works on: a tree over the points, or over some of them, cut into leaves, and which leaves
/// lie near each other. Regions grow from leaf to leaf: a list of neighbours for every point would take 64 B a point,
/// that of the leaves takes 4.
struct GrowingPoints {
  std::shared_ptr<const Octree> tree;
  Buffer<double> xyz = {};               ///< the tree's, when it is not the scene's
  std::vector<uint32_t> positions = {};  ///< in the scene of the tree's points; empty: the same
  double points_per_member = 1;          ///< free points of the scene for one of the tree's
  Buffer<uint8_t> isolated =
      {};  ///< 1: the point lies off its neighbours, no surface goes through it
  Buffer<float> leaf_spacing =
      {};  ///< median of its points; negative: nothing grows through this leaf
  LeafGraph graph = {};

  std::span<const uint32_t> leaf_first() const { return leaf_firsts(*tree); }
  size_t leaves() const { return leaf_first().size() - 1; }
  /// Position in the scene.
  uint32_t position(size_t point) const {
    return positions.empty() ? static_cast<uint32_t>(point) : positions[point];
  }
};

/// The free points or, where they are much denser than the tolerance is wide, one of each cell of about the tolerance:
/// noise would leave nothing of the normals of such points, and more of them do not make a region truer. Writes normals
/// and spacing of the scene's free points. In a second round, with the points of found surfaces gone, the normals at
/// edges, which these had bent, become right. At least one point must be free.
GrowingPoints points_to_grow(SegmentScene& scene, const GrowingSettings& settings, Task& task);

}  // namespace jalon
