// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/diagnosis.h"

namespace jalon {

/// How much stands behind a change of a diagnosis by evidence, 0 ... 1: by its changed points of both epochs. Not
/// calibrated yet: it orders changes and is no probability of their classes.
double confidence_by_points(const Change& change, const Epoch& before, const Epoch& after);

}  // namespace jalon
