// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/registration.h"
#include "registration/targets/solution.h"

namespace jalon {

/// Pose, covariance and tables of a solution.
///
/// Before: out has converged and stopped. After: all its other members are set, in the caller's
/// coordinates; residuals and pair_names have a row a pair, those in use first.
void describe_targets(const TargetSets& sets, const TargetSolution& solution,
                      const TargetSettings& setting, Registration& out);

}  // namespace jalon
