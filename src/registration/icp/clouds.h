// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/vec.h"
#include "registration/surface/planes.h"

namespace jalon {

// Legend of ICP, for all files of this folder.
//
// Forms of a cloud, one name each, of the reference and of the moving one:
//   raw          as the caller gave it (CloudPtr); its points have an index
//   thinned      ThinnedCloud: centroids of cubes, or raw itself; what is registered
//   surface      SurfacePlanes: the thinned points in the order of their octree, each with the
//                plane of the surface about it; its points have a position
//   level        LevelPoints: the positions that take part at one level, from few points to all
//
// Frames:
//   world        coordinates of the caller
//   reference,   begin at the origin of the cube of that cloud's octree, axes as in the world, so
//   moving       that coordinates of seven digits do not come in
//   T_a_b        takes places in frame b to frame a. Sought: T_reference_moving; between the
//                caller's coordinates T_reference_moving_world
//
// Symbols, of a pair (IcpPair) and of the adjustment (IcpSums, PatchSums):
//   m, r         positions of a moving point and of a reference point
//   place        of the pair: the moving point after the motion, in the reference frame
//   n            unit normal of the plane of the pair; planes have no outer side
//   r, residual  height of the moved side above the other along n, m
//   x            unknowns of a step, all in m: turn about the centre (rad) times the extent, shift
//   j            derivative of r by x: ((place - centre) / extent x n, n)
//   w, psi       weight of the kernel at r; psi = w r
//   N, b         normal equations N x = b: sum of w j j^T, sum of -w r j
//   noise_m      scatter of a cloud's points about their surface; sigma_m: scale of the residuals

/// The points of one cloud that take part at a level.
struct LevelPoints {
  std::vector<uint32_t> positions;  ///< in the surface, ascending; empty: all of them
  /// How far apart points of one surface may be sideways, besides the planes' radii.
  double reach_m = 0;

  size_t count(const SurfacePlanes& surface) const {
    return positions.empty() ? surface.size() : positions.size();
  }
  uint32_t position(size_t i) const {
    return positions.empty() ? static_cast<uint32_t>(i) : positions[i];
  }
};

/// One level of the coarse-to-fine search; as it comes: the last one, of all points.
struct IcpLevel {
  LevelPoints reference, moving;
  int number = 0;    ///< 0: the fewest points
  bool last = true;  ///< of all levels: the pose settles on it
};

/// The surfaces of both clouds, each in its own frame.
struct IcpClouds {
  SurfacePlanes reference, moving;

  /// T_reference_moving of a pose between the caller's coordinates, and back. Before: rigid.
  Transform to_local(const Transform& T_reference_moving_world) const;
  Transform to_world(const Transform& T_reference_moving) const;
};

}  // namespace jalon
