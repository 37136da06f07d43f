// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/opening_list.h"

namespace jalon {

/// Standard deviations of an opening's width, height and depth by propagation. Width and height: from the covariances
/// of the corners that hold its left and right, low and high sides (the corners of one side share its error, so that
/// their mean variance counts once; the crown of an arc moves with its ends). Depth: from the covariances of the planes
/// of wall and joinery at the middle of the opening. NaN where the model has no covariance.
void set_precision(OpeningRow& row, const Model& model);

/// What a report tells of a plane's precision.
struct PlanePrecision {
  double sigma_normal_rad = 0;  ///< in the direction in which the normal is least certain
  double sigma_offset_m = 0;    ///< of the plane's place at the middle of its points
};
PlanePrecision plane_precision(const PlaneFit& fit);

/// Standard deviation of the distance of a plane at a point, from the covariance of its normal and offset.
double sigma_at(const std::array<double, 16>& covariance, const Vec3& p);

}  // namespace jalon
