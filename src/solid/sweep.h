// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "solid/convex_piece.h"
#include "solid/triangle_boxes.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// What a gauge may meet: points, triangles, or both.
struct Obstacles {
  const Octree* octree = nullptr;  ///< of xyz
  std::span<const double> xyz;
  const TriangleBoxes* triangles = nullptr;
};

/// The numbers of jalon/clearance.h.
enum class ObstacleKind : uint8_t { kNone = 0, kPoint = 1, kFace = 2 };

/// Where an obstacle is nearest to the gauge, or deepest in it.
struct SweepPlace {
  ObstacleKind kind = ObstacleKind::kNone;
  uint32_t index = 0;      ///< of the point or the triangle
  uint32_t piece = 0;      ///< of the gauge
  uint32_t interval = 0;   ///< from pose interval to the next
  double time = 0;         ///< 0 ... 1 in the interval
  double clearance_m = 0;  ///< negative: this deep in the piece
  Vec3 obstacle,
      gauge;  ///< world: the point of the obstacle, and the nearest one of the piece's surface
};

struct SweepSettings {
  double margin_m = 0;  ///< every obstacle that comes closer is a place
  double reach_m = 1;   ///< the least clearance of each interval is found up to here
};

struct SweepResult {
  std::vector<SweepPlace> intervals;  ///< the least clearance of each; kNone: nothing within reach
  std::vector<uint64_t> near_counts;  ///< obstacles closer than the margin, of each interval
  std::vector<SweepPlace>
      places;  ///< each obstacle closer than the margin once, points first, by index
};

/// A gauge along its poses (T_world_gauge, rigid): one interval a pair of neighbours, or one for a single pose. Values
/// to 1e-6 m; see least_during for why nothing is missed. Parallel over the intervals; the same bits for any number of
/// threads.
SweepResult sweep_gauge(std::span<const ConvexPiece> pieces, std::span<const Transform> poses,
                        const Obstacles& obstacles, const SweepSettings& settings, Task& task);

}  // namespace jalon
