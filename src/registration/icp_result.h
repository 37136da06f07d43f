// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cloud/cloud.h"
#include "registration/icp_iterations.h"

namespace jalon {

/// The registration that the iterations ended with: pose, covariance, directions, log and residuals.
Registration icp_result(const IcpClouds& clouds, const IcpSettings& settings, const IcpState& state, Task& task);

}  // namespace jalon
