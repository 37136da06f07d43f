// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "segment/ransac/curved_hypotheses.h"
#include "segment/surface/connectivity.h"
#include "segment/surface/surface_map.h"

namespace jalon {

constexpr size_t kPointsPerBlock = 64;  ///< that are looked at together, neighbours along the curve

/// What sharing out asks of a surface.
struct SurfacePatch {
  Plane plane;
  Curved curved;  ///< instead of the plane, where it exists
  double core_m = 0;
  double weight = 0;    ///< 1 / sigma^2
  double evidence = 0;  ///< 2 ln(sigma / density)
  FlatFrame frame;
  SurfaceMap map;  ///< instead of the frame, for a curved surface
  Raster mask;     ///< the surface's pixels and their neighbours; empty without connectivity
  Box3 box;

  bool reaches(const Vec3& p) const {
    if (mask.size() == 0) return true;
    return mask.holds(curved.exists() ? map(p) : frame(p));
  }
  /// True only when it reaches all points of a box. slack_m: beyond the rounding of a projection.
  bool reaches_all(const Box3& of_points, double slack_m) const;
  bool inconsistent(const SegmentScene& scene, size_t position, double min_cosine) const {
    return curved.exists() ? curved_inconsistent(scene, curved, position)
                           : scene.inconsistent(position, plane.normal, min_cosine);
  }
  /// What else than a mask tells where it may be.
  SurfacePatch outline() const {
    SurfacePatch out;
    out.plane = plane;
    out.curved = curved;
    out.box = box;
    return out;
  }
};

/// Points that follow one another, kPointsPerBlock at most, with the box of their places.
struct SharedBlock {
  size_t first, last;
  const Box3& box;
};

/// Owners of a block's points, one for each, among the patches named by near: 1 + the patch's number, 0 = none. The
/// cost is -2 ln of the likelihood of the mixture of surfaces, density / sigma exp(-d^2 / (2 sigma^2)): where a thin
/// cloud of clutter cuts a wall, the points there are the wall's. Within the core of a plane the normal has no say: it
/// is that of a cell, and at an edge of two surfaces the cell holds both, so that a column of the wall beside a reveal
/// would become the reveal's.
void choose_owners(const SegmentScene& scene, const std::vector<SurfacePatch>& patches,
                   std::span<const uint32_t> near, const SharedBlock& block, uint32_t* owners);

}  // namespace jalon
