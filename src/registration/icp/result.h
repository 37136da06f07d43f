// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/icp/iterations.h"

namespace jalon {

/// The registration that the iterations ended with: pose between the caller's coordinates,
/// covariance, directions, log, and residuals of the raw points.
///
/// Before: state is where icp_iterate and icp_settle left it. After: covariance NaN and no
/// direction observable where the iterations ended before the level of all points, or with too few
/// pairs.
Registration icp_result(const IcpProblem& problem, const IcpState& state, Task& task);

}  // namespace jalon
