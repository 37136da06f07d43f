// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/icp/iterations.h"
#include "registration/registration.h"
#include "registration/verdict/sights.h"

namespace jalon {

/// Both clouds as the verdict looks at them. The problem outlives it.
struct IcpJudged {
  std::unique_ptr<const SurfacePlanes> steady_reference,
      steady_moving;  ///< of points in lines: what they are judged by
  JudgedCloud reference, moving;
};

/// misfit_m: of the residuals at the pose. O(points), to find where the clouds were taken from.
IcpJudged icp_judged(const Cloud& reference, const Cloud& moving, const IcpProblem& problem,
                     double misfit_m, Task& task);

/// Judges the pose that the steps ended with, and adds what was found to the result. better_m: PoseEvidence.
void icp_judge(const IcpJudged& judged, const IcpState& state, double better_m, Registration& out,
               Task& task);

}  // namespace jalon
