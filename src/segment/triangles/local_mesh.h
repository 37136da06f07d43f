// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Triangles over the points of a tree that need not close up to one surface.
struct LocalMesh {
  std::vector<std::array<uint32_t, 3>> triangles;  ///< sorted positions, ascending in each
  std::vector<uint32_t> first;                     ///< places in at_point, one more than points
  std::vector<uint32_t> at_point;                  ///< triangles at each point
  std::vector<float> roughness_m;  ///< of each point's neighbourhood: its distances from its plane

  std::span<const uint32_t> triangles_at(uint32_t point) const {
    return {at_point.data() + first[point], first[point + 1] - first[point]};
  }
};

using TriangleCorners = std::array<uint32_t, 3>;
TriangleCorners ascending_corners(uint32_t a, uint32_t b, uint32_t c);
/// The mesh gets the triangles, and knows which of them are at each of so many points.
void take_triangles(LocalMesh& mesh, std::vector<TriangleCorners> triangles, size_t points,
                    Task& task);

/// What makes a triangle.
struct MeshRule {
  uint32_t k = 16;
  double search_m = 0;       ///< longest edge; 0 = three local spacings
  uint32_t least_stars = 2;  ///< of its corners that see it: 1 lets triangles jump over edges
};

/// Localised Delaunay triangulation (Gopi, Krishnan & Silva 2000): each point's star in the plane of its k nearest; a
/// triangle is kept when the stars of two of its corners at least have it and no edge is longer than the search
/// distance. So no empty circle is violated from one side only, which is how triangles come to jump over edges.
LocalMesh local_mesh(const Octree& tree, const MeshRule& rule, Task& task);

}  // namespace jalon
