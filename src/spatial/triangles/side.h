// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec.h"
#include "spatial/triangles/nearest.h"
#include "spatial/triangles/nearest_kernel.h"

// On which side of a surface of triangles a point lies.

namespace jalon {

struct ClosestOfTriangle {
  TriangleFeature feature;
  Vec3 foot;   ///< the closest point; with the point, relative to the tree's origin
  Vec3 above;  ///< from it to the point
};
/// Of one triangle of a leaf.
ClosestOfTriangle closest_of(const TriangleBlock& block, uint32_t lane, const Vec3& point);

struct SideOfSurface {
  bool is_behind;
  TriangleSide basis;
};
/// Of a point, at the closest point of its nearest triangle. span_m: of the whole mesh.
SideOfSurface side_of_surface(const TriangleBlocks& tree, const TriangleBlock& block, uint32_t lane,
                              const ClosestOfTriangle& closest, double span_m);

}  // namespace jalon
