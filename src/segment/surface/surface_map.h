// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/task.h"
#include "segment/segmentation.h"

namespace jalon {

/// Takes points near a surface to metres on a flat map, so that rasters tell what is connected and how large it is:
/// planes as they are, cylinders unrolled, spheres by Lambert's azimuthal equal-area map about the side that was seen.
class SurfaceMap {
 public:
  SurfaceMap() = default;
  static SurfaceMap of_plane(const Plane& plane, const Vec3& near);
  /// Cut open along the widest stretch without points.
  static SurfaceMap of_cylinder(const Cylinder& cylinder, std::span<const Vec3> points, Task& task);
  static SurfaceMap of_sphere(const Sphere& sphere, std::span<const Vec3> points, Task& task);
  /// By the segment's type; points in the frame of its fit.
  static SurfaceMap of(const Segment& segment, std::span<const Vec3> points, Task& task);

  Vec2 operator()(const Vec3& p) const;

 private:
  PrimitiveType type_ = PrimitiveType::kPlane;
  Vec3 centre_, u_, v_, w_;  ///< w_: axis of a cylinder, middle of the seen side of a sphere
  double radius_ = 0;
};

}  // namespace jalon
