// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/icp/iterations.h"
#include "registration/icp/thinning.h"

namespace jalon {

/// The registration that the iterations ended with: pose, covariance, directions, log and residuals.
Registration icp_result(const IcpClouds& clouds, const IcpSource& reference, const IcpSource& moving,
                        const IcpSettings& settings, const IcpState& state, Task& task);

}  // namespace jalon
