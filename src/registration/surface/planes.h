// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "geometry/vec.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// What the plane of a point comes from.
enum class SurfaceShape : uint8_t {
  kPlane,    ///< through all neighbours
  kQuadric,  ///< touches a paraboloid through all neighbours
  kFace,     ///< through those neighbours alone that lie on the face of the point
};

/// The plane of the surface at a point: what one point of a cloud knows of it.
struct SurfacePlane {
  float normal[3];
  float height_m;  ///< of the plane above the point, along the normal
  float sigma_m;   ///< scatter of the neighbours about the surface; infinity: no plane
  float
      tilt_rad;  ///< standard deviation of the normal about an axis in the plane, mean of all axes
  float
      radius_m;  ///< root mean square distance of the neighbours from their centroid, in the plane
  SurfaceShape shape;

  Vec3 unit() const { return {normal[0], normal[1], normal[2]}; }
};

/// The planes of all points of a cloud, in the tree's order. Places are relative to the origin of the tree's cube.
struct SurfacePlanes {
  std::shared_ptr<const Octree> tree;
  Buffer<SurfacePlane> planes;
  double noise_m = 0;   ///< median scatter: of the points where the surface is flat
  double flat_m = 0;    ///< planes that scatter more run across an edge or lie on no surface
  double radius_m = 0;  ///< median

  size_t size() const { return planes.size(); }
  Vec3 place(size_t position) const { return tree->local(position); }
  bool flat(size_t position) const { return planes[position].sigma_m <= flat_m; }
};

/// By least squares through the k nearest points. Where these scatter more than the noise, the
/// plane that touches a paraboloid through them (round columns); where that fits no better, near
/// edges, where they lie on several faces, the plane through those of them that lie on the face of
/// the point.
///
/// Before: two points or more. After: a plane for each point, of infinite sigma_m where there is
/// none; noise_m, flat_m and radius_m are medians over samples of them. O(n k).
SurfacePlanes surface_planes(std::shared_ptr<const Octree> tree, uint32_t k, Task& task);

/// The deepest level of the octree with at most so many occupied cells.
int deepest_level(const Octree& tree, size_t most_cells, Task& task);

/// The flattest point of each occupied cell of a level of the octree, one for each of the three
/// axes that its normal is nearest to, so that small faces of a rare direction have their say
/// (normal-space sampling, Rusinkiewicz & Levoy 2001). After: positions of flat points, ascending,
/// none twice.
std::vector<uint32_t> flattest_points(const SurfacePlanes& planes, int level, Task& task);

}  // namespace jalon
