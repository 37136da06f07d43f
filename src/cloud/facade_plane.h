// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cloud/cloud.h"
#include "geometry/plane.h"

namespace jalon {

/// Where the scanner stood, if known.
struct Viewpoint {
  bool known = false;
  Vec3 position;
};

/// The main vertical plane of a scan; everything relative to origin (whole metres).
struct FacadePlane {
  Vec3 origin;
  Plane plane;  ///< distance() is positive toward the scanner
  Vec3 along;   ///< horizontal direction in the plane
  Vec3 up;      ///< the other one; along x up = +- normal
};

/// Boulaassal 2010, 3.3: the vertical plane that holds most points within tolerance_m
/// (half-thickness), by seeded RANSAC on a subsample, then least squares. vertical_tolerance_rad:
/// largest lean. Error(kDegenerate) when the points have no vertical extent in any plane.
FacadePlane find_facade_plane(const Cloud& cloud, double tolerance_m, double vertical_tolerance_rad,
                              const Viewpoint& viewpoint, uint64_t seed, Task& task);

/// The horizontal plane at the foot, relative to the facade's origin; normal up.
struct GroundPlane {
  Plane plane;
};
/// The most populous plane leaning less than 10 degrees from the horizontal among the lowest
/// points, then least squares on all points within tolerance_m of it; false when there is none.
bool find_ground(const Cloud& cloud, const FacadePlane& facade, double tolerance_m, uint64_t seed,
                 Task& task, GroundPlane& out);

}  // namespace jalon
