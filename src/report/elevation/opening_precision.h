// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/elevation/opening_list.h"

namespace jalon {

/// Standard deviations of an opening's width, height and depth by propagation. Width and height: from the covariances
/// of the corners that hold its left and right, low and high sides (the corners of one side share its error, so that
/// their mean variance counts once; the crown of an arc moves with its ends). Depth: from the covariances of the planes
/// of wall and joinery at the middle of the opening. NaN where the model has no covariance.
void set_precision(OpeningRow& row, const Model& model);

/// Standard deviation of the distance of a plane at a point, from the covariance of its normal and offset.
double sigma_at(const std::array<double, 16>& covariance, const Vec3& p);

}  // namespace jalon
