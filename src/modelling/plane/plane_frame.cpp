// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/plane_frame.h"

#include <cmath>

namespace jalon {

namespace {

// |cos| of the slope below which "up" is clear: planes flatter than 18 degrees are drawn as plans.
constexpr double kHorizontal = 0.95;

}  // namespace

PlaneFrame plane_frame(const Plane& plane, const Vec3& origin, const Vec3& facade_x) {
  PlaneFrame frame;
  frame.origin = origin;
  frame.normal = plane.normal;
  const Vec3& n = plane.normal;
  if (std::fabs(n.z) < kHorizontal) {
    frame.axis_u = normalized(Vec3{-n.y, n.x, 0});  // Z x n: horizontal, in the plane
  } else {
    frame.axis_u = normalized(facade_x - n * dot(n, facade_x));
    if (frame.axis_u == Vec3{}) frame.axis_u = normalized(Vec3{n.z, 0, -n.x});
  }
  frame.axis_v = cross(n, frame.axis_u);
  frame.height = plane.offset - dot(n, origin);
  return frame;
}

}  // namespace jalon
