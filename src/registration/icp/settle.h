// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/icp/iterations.h"

namespace jalon {

/// The last steps, on patches of both clouds instead of pairs. Only a converged pose of the metric
/// point to plane with a robust kernel and without trimming settles, where the patches say at least
/// half of what the pairs could in every direction: in a wood there are none.
///
/// After: either the pose is that of the patches, which state.patches holds, or the pose is as it
/// was and state.patches is empty; the log has a row a step tried. state.last stays that of the
/// pairs.
void icp_settle(const IcpProblem& problem, IcpState& state, Task& task);

/// Covariance of what patches fix, in the observable directions, 0 in the others: of an M-estimator
/// (Huber & Ronchetti 2009, 7.6). In lengths: turns are scaled by the extent.
Square<6> patch_covariance(const PatchSums& sums, const IcpDirections& directions);

}  // namespace jalon
