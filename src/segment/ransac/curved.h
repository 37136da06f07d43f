// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/segmentation.h"
#include "segment/surface/surface_map.h"

namespace jalon {

/// A sphere or a cylinder in the local frame; as made, neither.
struct Curved {
  PrimitiveType type = PrimitiveType::kPlane;  ///< kPlane: no curved surface
  Vec3 centre;                                 ///< of the sphere; a point of the cylinder's axis
  Vec3 axis;                                   ///< unit vector; zero for a sphere
  double radius = 0;

  Curved() = default;
  explicit Curved(const Sphere& s)
      : type(PrimitiveType::kSphere), centre(s.centre), radius(s.radius) {}
  explicit Curved(const Cylinder& c)
      : type(PrimitiveType::kCylinder), centre(c.point), axis(c.direction), radius(c.radius) {}

  bool exists() const { return type != PrimitiveType::kPlane; }
  bool is_sphere() const { return type == PrimitiveType::kSphere; }
  /// From the centre or from the axis to the point.
  Vec3 outward(const Vec3& p) const {
    const Vec3 d = p - centre;
    return d - dot(d, axis) * axis;
  }
  /// Signed: positive outside.
  double distance(const Vec3& p) const { return norm(outward(p)) - radius; }
  Sphere sphere() const { return {centre, radius}; }
  Cylinder cylinder() const { return {centre, axis, radius}; }
  /// Points near it to metres on a flat map.
  SurfaceMap map(std::span<const Vec3> points, Task& task) const {
    return is_sphere() ? SurfaceMap::of_sphere(sphere(), points, task)
                       : SurfaceMap::of_cylinder(cylinder(), points, task);
  }
};

/// Adjusts a curved surface to points from a start: type, sphere or cylinder of `out`. False when they do not fix it.
bool adjust_curved(std::span<const Vec3> points, const Curved& start,
                   const PrimitiveSetting& setting, Task& task, Segment& out);
/// The surface of a segment that is no plane.
Curved curved_of(const Segment& segment);

}  // namespace jalon
