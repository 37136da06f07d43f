// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "compare/landslide/cell_table.h"

namespace jalon {

/// A piece of a set of cells that hang together over their edges: its outline anticlockwise, what it leaves out
/// clockwise. Corners in metres along u and v from the first cell's centre.
struct CellPiece {
  std::vector<Vec2> outline;
  std::vector<std::vector<Vec2>> openings;
  std::vector<uint32_t> rows;  ///< of its cells
};

/// The pieces of the rows that belong, in the order of their first cells; at least so many cells each. Rings run
/// through the middles of the cells' edges, so that a slant border is no staircase; what that cuts off at corners it
/// adds at the others.
std::vector<CellPiece> cell_pieces(const CellTable& cells,
                                   const std::function<bool(size_t row)>& belongs, size_t fewest);

}  // namespace jalon
