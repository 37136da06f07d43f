// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "registration/coarse/settings.h"
#include "registration/registration.h"

namespace jalon {

/// Parameter table of method "coarse".
std::span<const ParamRow> coarse_rows();

/// A pose without a guess, good enough for ICP to begin with, or the word that there is none or
/// more than one. Legend: surface.h.
/// 1. Both clouds thinned alike, with local planes and features (Rusu, Blodow & Beetz 2009).
/// 2. Candidates: cliques of feature matches that keep their distances (Chen et al. 1999; Yang,
///    Shi & Carlone 2021), and planes matched by angles and distances.
/// 3. The candidates' overlap from both sides, the best settled point to plane (Chen & Medioni
///    1992).
/// 4. The best against the best one that is clearly different.
/// T_start: one candidate more, and what the limits are counted from; the pose where nothing is
/// found. kInsufficientData for clouds of fewer than 50 points or cells. Draws nothing by chance.
Registration register_coarse(const CloudPtr& reference, const CloudPtr& moving,
                             const Transform& T_start, const CoarseSettings& settings, Task& task);

}  // namespace jalon
