// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/icp/iterations.h"

namespace jalon {

/// The last steps, on patches of both clouds instead of pairs. Only a converged pose of the metric point to plane with
/// a robust kernel settles, where the patches say at least half of what the pairs could in every direction: in a wood
/// there are none. Its neighbours, rule and kernel stay those of the pairs.
void icp_settle(const IcpClouds& clouds, const IcpSettings& settings, Task& task, IcpState& state);

/// Covariance of what patches fix, in the observable directions: of an M-estimator (Huber & Ronchetti 2009, 7.6).
Square<6> patch_covariance(const PatchSums& sums, const IcpDirections& directions);

}  // namespace jalon
