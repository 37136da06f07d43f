// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane.h"
#include "segment/triangles/local_mesh.h"

namespace jalon {

/// How regions grow over triangles.
struct TriangleRule {
  double tolerance_m = 0;  ///< of a corner from its region's plane
  double angle_rad = 0;    ///< between a triangle and the plane, beyond what the noise turns it by
  uint64_t least_points = 3;  ///< of a region
};

/// Regions of a mesh, numbered from 1 as they were found.
struct TriangleRegions {
  std::vector<uint32_t> labels;  ///< one a point, 0 = none
  std::vector<Plane> planes;     ///< in the tree's coordinates
};

/// Surface growing over triangles (the second of three methods for planes compared in France in 2006): seeds are the
/// stars of the smoothest points; of the triangles beside a region those join whose corners lie in its plane and which
/// lie as it does; the plane is refitted from running moments. A triangle refused is not asked again by the region.
/// O(triangles).
TriangleRegions grow_triangles(const Octree& tree, LocalMesh mesh, const TriangleRule& rule,
                               Task& task);

}  // namespace jalon
