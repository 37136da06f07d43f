// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/joint/ray_matching.h"
#include "registration/solvers/joint_problem.h"

namespace jalon {

/// The offset of a strip by its points alone, where everything but the strip stands here.
double strip_misfit_m(const StripCondition& strip, const JointPlaces& places,
                      const Vec3& attitude_rad);

/// The standard deviations from which of so many strips one is off in one drive of twenty: of a strip that is farther
/// off its wall may as well be another's.
double rare_deviations(size_t strips);

}  // namespace jalon
