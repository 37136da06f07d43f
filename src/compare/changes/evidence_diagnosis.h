// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/object_motion.h"

namespace jalon {

/// Whether both comparisons tell of every point what speaks for a change ("detection" of method distance).
bool has_evidence(const Comparison& forward, const Comparison& reverse);

/// Classes of changes from regions whose points all speak for one: 1. pieces of one change; 2. a surface that moved as
/// a part of a larger one is a deformation; 3. what changed in both epochs otherwise moved or was deformed; 4. of one
/// epoch alone: a twin within reach is the same thing moved, else it appeared or went; 5. those of too few points are
/// left out, the others have their confidence. Cost grows with the changed points. The epochs have their regions.
std::vector<Change> classes_by_evidence(const ObjectMotionJob& job, double twin_reach);

}  // namespace jalon
