// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "registration/judgement.h"
#include "registration/verdict/evidence.h"

namespace jalon {

/// Whether two clouds bear a pose out.
///
/// The confidence is a logistic regression on how much speaks against the pose: shares contradicted, not explained
/// and pierced. Accepted: at least 0.8 and nothing else against it; refused: at most 0.1. It is doubtful besides when
/// too little of one cloud lies on the other, when the clouds want a different scale, when directions stay open, or
/// when the steps have not settled.
PoseJudgement judge_pose(const PoseEvidence& evidence, bool has_converged, uint64_t unobservable);

}  // namespace jalon
