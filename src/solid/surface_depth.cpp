// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/surface_depth.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/error.h"
#include "solid/triangle_contact.h"

namespace jalon {

namespace {

using SurfaceDepthCorners = std::array<Vec3, 3>;

Depth depth_in_convex(const PartSurface& surface, const ConvexPiece& piece) {
  Depth deepest;
  for (uint32_t t = 0; t < surface.boxes().size(); ++t) {
    const Contact contact = least_distance(piece, surface.boxes().corners(t));
    if (-contact.value > deepest.depth_m)
      deepest = {-contact.value, contact.point, contact.point - contact.gradient * contact.value};
  }
  return deepest;
}

std::array<SurfaceDepthCorners, 4> quarters(const SurfaceDepthCorners& c) {
  const Vec3 ab = (c[0] + c[1]) * 0.5, bc = (c[1] + c[2]) * 0.5, ca = (c[2] + c[0]) * 0.5;
  return {{{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {ab, bc, ca}}};
}

// Cuts one triangle until no piece can hold a point deeper than the deepest so far by more than the tolerance.
void search(const SurfaceDepthCorners& triangle, const NearestTriangles& closed, double tolerance_m,
            const Task& task, Depth& deepest) {
  std::vector<SurfaceDepthCorners> open{triangle};
  while (!open.empty()) {
    if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
    const SurfaceDepthCorners c = open.back();
    open.pop_back();
    const Vec3 middle = (c[0] + c[1] + c[2]) / 3;
    const double radius = std::max({norm(c[0] - middle), norm(c[1] - middle), norm(c[2] - middle)});
    const TriangleAnswer answer = closed.nearest(middle);
    const double depth = answer.is_behind ? answer.distance : -answer.distance;
    if (depth > deepest.depth_m) deepest = {depth, middle, answer.foot};
    if (depth + radius <= deepest.depth_m + tolerance_m) continue;
    for (const SurfaceDepthCorners& quarter : quarters(c)) open.push_back(quarter);
  }
}

}  // namespace

Depth depth_in(const PartSurface& surface, const PartSurface& closed, double tolerance_m,
               Task& task) {
  if (closed.convex()) return depth_in_convex(surface, *closed.convex());
  // 1. The corners: where most surfaces are deepest.
  Depth deepest;
  for (const Vec3& corner : surface.boxes().vertices()) {
    const TriangleAnswer answer = closed.nearest().nearest(corner);
    if (answer.is_behind && answer.distance > deepest.depth_m)
      deepest = {answer.distance, corner, answer.foot};
  }
  // 2. What lies between them.
  for (uint32_t t = 0; t < surface.boxes().size(); ++t)
    search(surface.boxes().corners(t), closed.nearest(), tolerance_m, task, deepest);
  return deepest;
}

}  // namespace jalon
