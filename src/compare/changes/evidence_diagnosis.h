// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/object_motion.h"

namespace jalon {

/// Whether both comparisons tell of every point what speaks for a change ("detection" of method distance).
bool has_evidence(const Comparison& forward, const Comparison& reverse);

struct WeighedChanges {
  std::vector<Change> changes;
  std::vector<Change> others;  ///< what was weighed against them and not chosen
};

/// Classes of changes from regions whose points all speak for one: 1. pieces of one change; those of too few points
/// are left out; 2. motions of the things that they are parts of, or that went at one place and came within reach at
/// another, each with its probability: what is more likely than not is taken (moved_things.h); 3. what is left came or
/// went, by the epoch that holds more of it, or gave way, or is one thing that went and another that came in its place:
/// what is more probable. Cost grows with the changed points.
/// The epochs have their regions.
WeighedChanges classes_by_evidence(const ObjectMotionJob& job, double twin_reach);

}  // namespace jalon
