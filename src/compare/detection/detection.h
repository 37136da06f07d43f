// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison.h"
#include "compare/detection/core_tests.h"

namespace jalon {

/// From distances to the nearest points to significant ones.
///
/// made: a comparison with the columns "distance", "nearest" and "status" of every point of compared. Gets "distance"
/// from the surface of the reference where there is one, "level_of_detection", "significant" (0 or 1) and "evidence";
/// what the reference could not see loses its distance and has the status hidden. The summary gets what was chosen.
/// use_stations: of the reference, where all its points have one.
void add_detection(const CloudPtr& reference, const CloudPtr& compared, bool use_stations,
                   const DetectionRates& rates, Comparison& made, Task& task);

/// The numbers of column "evidence".
enum class ChangeEvidence : uint8_t { kNone = 0, kMovedSurface = 1, kSeenThrough = 2 };

}  // namespace jalon
