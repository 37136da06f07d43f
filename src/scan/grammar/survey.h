// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scan/facade_truth.h"
#include "scan/grammar/plan.h"

namespace jalon::grammar {

/// Where the scanner stands before the plan's facade, in the scene's own frame, and how it measures.
SceneSurvey survey_of(const Plan& plan, const GrammarSettings& settings, uint64_t seed);

bool has_glass(const GrammarSettings& settings, uint64_t seed);
bool has_occluders(const GrammarSettings& settings, uint64_t seed);
/// From the front to beyond the farthest station.
double reach_m(const SceneSurvey& survey);

}  // namespace jalon::grammar
