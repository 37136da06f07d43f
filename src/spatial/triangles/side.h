// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/vec.h"
#include "spatial/triangles/nearest.h"
#include "spatial/triangles/nearest_kernel.h"
#include "spatial/triangles/stacks.h"

// On which side of a surface of triangles a point lies.

namespace jalon {

struct ClosestOfTriangle {
  TriangleFeature feature;
  Vec3 foot;   ///< the closest point; with the point, relative to the tree's origin
  Vec3 above;  ///< from it to the point
};
/// Of one triangle of a leaf.
ClosestOfTriangle closest_of(const TriangleBlock& block, uint32_t lane, const Vec3& point);

/// Triangles touch a point when they are closer to it than this share of the whole mesh: some hundred roundings.
constexpr double kTouchingShare = 0x1p-44;

/// The triangles that may touch a point.
struct TouchingTriangles {
  TriangleBlocks tree;
  const TriangleStack* stacks = nullptr;  ///< at 4 x block + lane; none: each is by itself
  double span_m = 0;                      ///< of the whole mesh
};

struct SideOfSurface {
  bool is_behind;
  TriangleSide basis;
};
/// Of a point, at the closest point of its nearest triangle, which is that of the block.
SideOfSurface side_of_surface(const TouchingTriangles& touching, const TriangleBlock& block,
                              uint32_t lane, const ClosestOfTriangle& closest);

}  // namespace jalon
