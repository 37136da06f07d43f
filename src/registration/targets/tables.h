// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/registration.h"
#include "registration/targets/solution.h"

namespace jalon {

/// Pose, covariance and tables of a solution; converged and stopped are set before.
void describe_targets(const TargetSets& sets, const TargetSolution& solution,
                      const TargetSettings& setting, Registration& out);

}  // namespace jalon
