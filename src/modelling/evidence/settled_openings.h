// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "modelling/evidence/evidence.h"

namespace jalon {

/// Openings of walls whose borders are covered by relief: their shapes fitted to the points of the wall and of the
/// relief before it: at most relief_m away, or a pilaster (point_fit.h).
///
/// Before: roles. After: shape and is_settled of such openings. The same bits for any number of threads. O(points of
/// the walls and their relief x such openings).
void settle_openings(const Segmentation& segmentation, const CellSetting& cells,
                     std::vector<WallEvidence>& all, Task& task);

}  // namespace jalon
