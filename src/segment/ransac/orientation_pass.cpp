// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/orientation_pass.h"

#include <cmath>

namespace jalon {

namespace {

// Largest angle between a hypothesis and the axis it is turned onto: the noise of three points in a cell of four
// tolerances, and that of the default consistency test between normals of cells and planes.
constexpr double kDrawTolerance_rad = 0.26;
constexpr double kSettledTolerances = 3;

}  // namespace

bool OrientationPass::shape(Plane& plane, const Vec3& about) const {
  if (wanted == Orientation::kNone) return true;
  if (wanted == Orientation::kInclined) return axes.classify(plane.normal, tolerance_rad) == wanted;
  const Vec3 axis = axes.axis(wanted);
  if (std::fabs(dot(plane.normal, axis)) < std::cos(draw_tolerance_rad)) return false;
  const Vec3 foot = about - plane.distance(about) * plane.normal;
  plane.normal = axis;
  plane.offset = dot(axis, foot);
  return true;
}

bool OrientationPass::accepts(const Vec3& normal) const {
  if (wanted == Orientation::kNone) return true;
  if (wanted == Orientation::kInclined) return axes.classify(normal, tolerance_rad) == wanted;
  return axes.classify(normal, kSettledTolerances * tolerance_rad) == wanted;
}

std::vector<OrientationPass> orientation_passes(RansacScene& scene, Task& task) {
  if (scene.order.count == 0) return {OrientationPass{}};
  std::vector<OrientationPass> passes;
  const FacadeAxes axes = facade_axes(scene, task);
  scene.axes = axes;
  const double tolerance_rad = scene.settings.orientation_tolerance_rad;
  for (uint32_t i = 0; i < scene.order.count; ++i)
    passes.push_back(
        {scene.order.classes[i], axes, tolerance_rad, std::max(kDrawTolerance_rad, tolerance_rad)});
  return passes;
}

}  // namespace jalon
