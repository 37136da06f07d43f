// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>

#include "modelling/evidence/box_search.h"
#include "modelling/evidence/opening_shape.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// What a cell inside an opening speaks for it, by state.
struct ShapeWeights {
  double on = -6, relief = -6, strip = -3, through = 2, proud = -2, deep = 1, hidden = 0.1,
         empty = 1, outside = -0.5;
  double clearly =
      1.03;  ///< times the rectangle's score that other kinds must have: what noise gains
  double of(WallState state) const {
    switch (state) {
      case WallState::kOn:
        return on;
      case WallState::kRelief:
        return relief;
      case WallState::kStrip:
        return strip;
      case WallState::kThrough:
        return through;
      case WallState::kProud:
        return proud;
      case WallState::kDeep:
        return deep;
      case WallState::kHidden:
        return hidden;
      case WallState::kOutside:
        return outside;
      case WallState::kEmpty:
        break;
    }
    return empty;
  }
};

struct FittedShape {
  OpeningShape shape;  ///< in cells from the lower left corner of the wall's
  double score = 0;    ///< sum of the weights inside, less what its sizes cost
};

/// The shape about a box that explains the cells best: the sum of the weights inside it less 3/2 log n for each of its
/// sizes (Rissanen 1978: minimum description length), n the number of cells, and less what naming a circle costs: of
/// few cells it, which has a size less than a rectangle, would be any window. Each kind starts in the box and moves its
/// sizes by halved steps while that gains. Shapes with sloping or curved sides must beat the rectangle clearly, and the
/// wall must be measured along these sides: nothing tells the form of a head that was not seen.
/// `taken`, a byte a cell, may be empty: cells of other openings, which speak against this one.
/// is_head_seen: whether the wall was measured along the sloping sides; by the cells where it is empty.
using HeadTest = std::function<bool(const OpeningShape&)>;
FittedShape fitted_shape(const WallCells& cells, std::span<const uint8_t> taken, const CellBox& box,
                         const ShapeWeights& weights, const HeadTest& is_head_seen = {});
bool has_seen_head(const WallCells& cells, const OpeningShape& shape);

}  // namespace jalon
