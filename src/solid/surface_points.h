// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "solid/surface.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// A point near a surface.
struct NearPoint {
  uint32_t point = 0, triangle = 0;
  double distance_m = 0;  ///< negative inside a closed surface
  Vec3 foot;              ///< the nearest point of the surface
};

struct PointClearance {
  NearPoint least;              ///< of all points: the nearest, or the deepest inside
  std::vector<NearPoint> near;  ///< all within the margin, and all inside, by index
  uint64_t inside = 0;
};

/// All points of the octree (at least one) against a surface (at least one triangle). Boxes of the octree that are
/// farther than the margin and than the nearest of a few corners are not opened; every answer is exact. Parallel.
PointClearance clearance_of_points(const PartSurface& surface, const Octree& octree,
                                   std::span<const double> xyz, double margin_m, Task& task);

}  // namespace jalon
