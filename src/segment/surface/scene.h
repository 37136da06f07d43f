// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "geometry/plane.h"
#include "segment/orientation.h"
#include "segment/surface/plane_kernel.h"
#include "segment/surface_settings.h"
#include "spatial/octree/octree.h"

namespace jalon {

constexpr uint8_t kMostRejections = 3;
constexpr size_t kRejectionBlock = 4096;  ///< positions, a page of their notes
constexpr size_t kFetchedAhead = 24;  ///< points whose doubles are let come before they are read

/// The octree's coordinates, at hand: every step reads those of all points.
struct GridCoordinates {
  const int32_t *x = nullptr, *y = nullptr, *z = nullptr;
  double step_m = 1;
};

/// What all steps of one run share. Points are named by their position in the octree's order; coordinates are
/// relative to the octree's cube, which is the run's own and moves with the cloud.
struct SegmentScene {
  const Cloud& cloud;
  SurfaceSettings settings;
  std::shared_ptr<const Octree> tree;
  std::span<const uint32_t> order = {};
  GridCoordinates grid = {};
  Vec3 origin = {};  ///< of the local frame
  int fine_level = 0, coarse_level = 0;
  std::vector<std::vector<uint32_t>> cell_firsts =
      {};  ///< of levels coarse_level ... fine_level, with the end behind

  std::vector<uint32_t> owner = {};  ///< segment that took the point, 0 = free
  std::vector<uint8_t> rejections =
      {};  ///< surfaces with the point that were no planes, since the last that was
  std::vector<uint8_t> curved_rejections =
      {};  ///< the same of spheres and cylinders; empty when none are looked for
  std::vector<uint8_t> rejected_blocks =
      {};                      ///< whether one of so many positions has a rejection of either kind
  Buffer<float> normals = {};  ///< 3 a point, NaN = unknown
  Buffer<float> spacing = {};  ///< local point spacing, m
  Buffer<uint8_t> level = {};  ///< level of the cell that gave normal and spacing

  std::optional<FacadeAxes> axes = {};  ///< when orientation classes were extracted one by one

  size_t size() const { return order.size(); }
  /// A free point that a draw may start from: not where draw after draw has led to the same surface and that was none.
  bool may_seed(size_t position) const {
    return owner[position] == 0 && rejections[position] < kMostRejections;
  }
  bool may_seed_curved(size_t position) const {
    return owner[position] == 0 && curved_rejections[position] < kMostRejections;
  }
  /// Notes in rejections or curved_rejections that a surface with the point was none.
  void note_rejection(std::vector<uint8_t>& counts, size_t position, uint8_t most) {
    if (counts[position] >= most) return;
    ++counts[position];
    rejected_blocks[position / kRejectionBlock] = 1;
  }
  /// All of both kinds, in the time that those took which were noted.
  void forget_rejections();
  /// The octree's cell around a point, at a level of cell_firsts.
  Octree::Cell cell_around(int at_level, uint32_t position) const;
  /// Edge of the cell that gave normal and spacing of the point.
  double cell_edge_m(size_t position) const {
    return std::ldexp(tree->cube().edge, -level[position]);
  }
  /// From the octree's grid: right to edge / 2^32.
  Vec3 local(size_t position) const {
    return Vec3{static_cast<double>(grid.x[position]), static_cast<double>(grid.y[position]),
                static_cast<double>(grid.z[position])} *
           grid.step_m;
  }
  /// From the caller's doubles.
  Vec3 exact(size_t position) const { return cloud.point(order[position]) - origin; }
  /// Lets the memory come that exact() is about to read: the caller's doubles stand in his order.
  void fetch_exact(size_t position) const {
    __builtin_prefetch(cloud.xyz_buffer->data() + 3 * size_t{order[position]});
  }
  /// Tolerance of the normal test as a cosine; 0 switches it off.
  double min_cosine() const {
    return settings.uses_normals() ? std::cos(settings.normal_tolerance_rad) : 0.0;
  }
  PlaneTest test(const Plane& plane, double tolerance_m, double cosine) const {
    return {static_cast<float>(plane.normal.x), static_cast<float>(plane.normal.y),
            static_cast<float>(plane.normal.z), static_cast<float>(plane.offset),
            static_cast<float>(tolerance_m),    static_cast<float>(cosine)};
  }
  /// True when the point has a normal that disagrees with the plane's.
  bool inconsistent(size_t position, const Vec3& normal, double cosine) const {
    const float* m = &normals[3 * position];
    return std::fabs(m[0] * normal.x + m[1] * normal.y + m[2] * normal.z) < cosine;
  }
};

/// Index and room for the columns of the points, all of them free; normals and spacing are still to be written.
SegmentScene indexed_scene(const Cloud& cloud, const SurfaceSettings& settings, Task& task);
/// Adds the octree's cells, and normals and spacing from them: in columns anew where these were given back.
void look_at_cells(SegmentScene& scene, Task& task);
/// Both.
SegmentScene scene_with_cells(const Cloud& cloud, const SurfaceSettings& settings, Task& task);

/// Gives back the index and the columns of the points; origin, settings and axes stay.
void release_points(SegmentScene& scene);

/// Normal, spacing and level of every free point: the finest cell with enough points decides (local_surface.cpp).
void estimate_local_surface(SegmentScene& scene, Task& task);

/// Normals of the points from the cloud's field "normal"; those that are not finite or zero count as unknown.
void take_field_normals(SegmentScene& scene, Task& task);

/// Axes of a plane that depend on its normal alone: u horizontal, v upward (for horizontal planes u = X).
struct SurfaceAxes {
  Vec3 u, v;
};
SurfaceAxes plane_axes(const Vec3& normal);

}  // namespace jalon
