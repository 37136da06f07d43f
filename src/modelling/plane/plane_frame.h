// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/plane.h"
#include "geometry/vec.h"

namespace jalon {

/// Drawing frame of a plane: u to the right and v up for an eye in front of it (the normal points at the eye); u x v =
/// normal.
///
/// v is the projection of world Z, so that horizontal and vertical mean what they say; on (nearly) horizontal planes u
/// is the projection of the facade's X axis (Boulaassal 2010, 4.3.1; never the principal axes, which are arbitrary on
/// square segments). origin lies near the points and off the plane: coordinates are taken relative to it, so that a
/// shift of cloud and origin by whole metres changes no bit of (u, v).
struct PlaneFrame {
  Vec3 origin, axis_u, axis_v, normal;
  double height = 0;  ///< of the plane above the origin, along the normal

  Vec2 project(const Vec3& p) const {
    const Vec3 d = p - origin;
    return {dot(d, axis_u), dot(d, axis_v)};
  }
  Vec3 lift(const Vec2& p) const { return origin + (axis_u * p.u + axis_v * p.v + normal * height); }
};

/// origin: any point near the data. facade_x: horizontal unit vector along the facade.
PlaneFrame plane_frame(const Plane& plane, const Vec3& origin, const Vec3& facade_x);

}  // namespace jalon
