// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/icp/iterations.h"
#include "registration/registration.h"

namespace jalon {

/// Judges the pose that the steps ended with by both clouds, and adds what was found to the result. O(points), to
/// find where the clouds were taken from.
void icp_judge(const Cloud& reference, const Cloud& moving, const IcpProblem& problem,
               const IcpState& state, Registration& out, Task& task);

}  // namespace jalon
