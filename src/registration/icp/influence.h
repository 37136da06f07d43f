// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/icp/normal.h"

namespace jalon {

/// Covariance of the right-hand side of the normal equations (unit weights): the sum over all
/// points of both clouds of sigma^2 b b^T, b what a point's noise along its normal puts into it. It
/// goes in with the pair of the point, and with the planes that go through it: a plane through n
/// points weighs each by 1 / n + u S^-1 u', u the places of the pair and of the point in the plane,
/// S the sums of products (the hat matrix of the plane).
///
/// Before: at is of all points, by the metric point to plane; k neighbours made the planes. After:
/// symmetric. Up to 100 000 points exactly, O(n k); above, over runs of neighbouring points, each
/// plane shared out evenly in its run.
Square<6> icp_influence(const IcpPairing& at, const IcpFrame& frame, uint32_t k, Task& task);

/// The same from the residuals themselves, for metrics in which points are not only planes'
/// members: the sum of s s^T, s the sum of r j over a group of neighbouring points, whose pairs are
/// not independent (Liang & Zeger 1986). Before: at is of all points.
Square<6> icp_scores(const IcpPairing& at, const IcpFrame& frame);

}  // namespace jalon
