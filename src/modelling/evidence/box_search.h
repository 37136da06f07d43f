// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "modelling/evidence/cell_regions.h"
#include "modelling/evidence/cell_sums.h"

namespace jalon {

struct ScoredBox {
  CellBox box;
  int64_t sum = 0;
};

/// The upright box with the greatest sum of scores (Bentley 1984: Kadane's scan for all pairs of rows), on a coarse
/// grid of at most 110 lines the shorter way, then its sides moved on the fine one while that gains.
///
/// Before: sums of columns x rows cells, both above 0. An empty box where no cell is above 0. O(lines^2 x other lines).
ScoredBox best_box(const CellSums<int64_t>& sums, uint32_t columns, uint32_t rows);

}  // namespace jalon
