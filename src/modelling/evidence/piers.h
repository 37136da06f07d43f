// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/evidence/box_search.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// Columns of a box in which the wall goes from its foot to its head, or in the next one where that has the rest, with
/// more on both sides than a light is wide: there two windows are parted by a pier, however narrow, and no window by a
/// mullion. What stands before such a pier hides most of its width.
std::vector<uint32_t> pier_columns(const WallCells& cells, const CellBox& box);

/// The larger part of a box beside its first pier; the box itself where it has none.
CellBox beside_pier(const WallCells& cells, const CellBox& box);

}  // namespace jalon
