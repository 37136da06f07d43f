// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/orientation.h"
#include "segment/ransac/ransac_scene.h"

namespace jalon {

/// Which planes one pass over the cloud takes (Boulaassal 2010, 3.4.5.2): those of one orientation class, or all.
struct OrientationPass {
  Orientation wanted = Orientation::kNone;  ///< kNone: all
  FacadeAxes axes;
  double tolerance_rad = 0;
  double draw_tolerance_rad = 0;

  /// Makes a hypothesis one of the class, or returns false. Three points close together say little about a direction
  /// (a base of 0.3 m and 8 mm of noise: 3 degrees), so a hypothesis within draw_tolerance_rad of the class's axis is
  /// turned onto it about the point; least squares finds the rest.
  bool shape(Plane& plane, const Vec3& about) const;
  /// The test after least squares. Wider than the class: as long as the other planes are not known,
  /// the strip of a wall in
  /// front of a sill of 0.2 m turns it by a degree.
  bool accepts(const Vec3& normal) const;
};

/// The passes of a run: one for all planes, or one a class in the order asked for; then scene.axes is set.
std::vector<OrientationPass> orientation_passes(RansacScene& scene, Task& task);

/// Axes of the main facade by the normals of the upright cells (facade_direction.cpp).
FacadeAxes facade_axes(const SegmentScene& scene, Task& task);

}  // namespace jalon
