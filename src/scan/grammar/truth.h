// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan/facade_truth.h"
#include "scan/grammar/plan.h"

namespace jalon::grammar {

/// Walls and openings of the plan as contours in the walls' planes; nothing of what is seen.
FacadeTruth truth_of(const Plan& plan, const Transform& T_world_scene);

/// Says of walls and openings what the survey's stations see of them in the model. Glass lets beams pass; what stands
/// out of a wall by less than kAttached_m hides nothing.
void look(const Model& model, const SceneSurvey& survey, FacadeTruth& truth, Task& task);
constexpr double kAttached_m = 0.06;

}  // namespace jalon::grammar
