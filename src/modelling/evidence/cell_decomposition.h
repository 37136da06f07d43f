// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "modelling/evidence/find_openings.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// Openings of a wall by cell decomposition (Boehm, Becker & Haala 2007; Haala, Becker & Kada 2006), the baseline of
/// find_openings():
/// 1. places where the wall's points end to the left, to the right, below and above;
/// 2. upright and level lines through many of them, each drawn across the whole wall, part it into cells;
/// 3. a cell is an opening where few of it is wall;
/// 4. cells of openings that touch are joined, as rectangles, the largest first.
/// A place that something hid is told as an opening, as is one that nobody looked at: the text knows no stations.
///
/// After: from left to right; shapes do not overlap.
std::vector<OpeningCandidate> decomposed_openings(const WallCells& cells,
                                                  const OpeningSearch& setting, Task& task);

}  // namespace jalon
