// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/cholesky.h"
#include "geometry/vec.h"
#include "registration/icp/normal.h"
#include "registration/icp/robust_kernel.h"

namespace jalon {

/// A point of either cloud on a patch, in the reference frame.
struct PatchPoint {
  Vec3 place;
  bool moving = false;
};

/// Normal equations of a pose and of the surfaces of many patches, these eliminated; unknowns as in
/// IcpSums. g: what of j is left when the surface has taken up its share.
struct PatchSums {
  Square<6> normal{};       ///< sum of slope g g^T: information on the pose that is left
  Coefficients<6> right{};  ///< sum of - psi(r) g
  Square<6> scatter{};      ///< sum of psi^2 g g^T: what the noise of both clouds puts into right
  double squares = 0, weights = 0,
         slopes = 0;  ///< sums of w r^2, of w and of the slope of psi = w r
  uint64_t points = 0, of_moving = 0, patches = 0;
  PatchSums& operator+=(const PatchSums& b);
};

/// Adds one patch: a plane, or where that does not do a paraboloid, through the points of both
/// clouds.
///
/// Before: normal is unit and about that of the surface; noise_m: standard deviation of the points.
/// After: sums.patches has grown by one, or, for fewer points than fix a surface and a shift
/// against each other, or where neither surface fits, nothing has changed. Costs about 100
/// operations a point.
void add_patch(const std::vector<PatchPoint>& points, const Vec3& normal, double noise_m,
               const RobustKernel& kernel, const IcpFrame& frame, PatchSums& sums);

}  // namespace jalon
