// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "modelling/evidence/opening_shape.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// f(column, row) of the cells whose centres lie in the shape, which is in cells.
template <class F>
void for_cells(const WallCells& cells, const OpeningShape& shape, F&& f) {
  const RingBox box = shape.box();
  const auto line = [](double at, uint32_t most) {
    return static_cast<uint32_t>(std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(most)));
  };
  for (uint32_t r = line(box.low.v, cells.rows); r < line(box.high.v, cells.rows); ++r) {
    const Vec2 span = shape.span_at(r + 0.5);
    for (uint32_t c = line(span.u, cells.columns); c < line(span.v, cells.columns); ++c) f(c, r);
  }
}

enum class Sides : uint8_t {
  kAll,
  kSloping,  ///< neither upright nor level
  kSteep,    ///< nearer to upright than to level: jambs
};

/// Share of the length of these sides of a shape (in cells) with wall just outside them, less what lies on the wall's
/// border; 1 without such sides.
double bordered_share(const WallCells& cells, const OpeningShape& shape, Sides sides);
/// Share of the length of these sides, the wall's border included but for its foot, beyond which the wall is as broad
/// as a pier, 0 without such sides: openings are framed, and where a wall ends nothing frames what lies beside it.
double framed_share(const WallCells& cells, const OpeningShape& shape, Sides sides = Sides::kAll);
/// At which ends and sides of a shape the wall ends, along most of them. At head and foot: it parts two pieces of the
/// wall, dormers or wings, and is no opening of either.
struct OpenEnds {
  bool head = false, foot = false, left = false, right = false;
};
OpenEnds open_ends(const WallCells& cells, const OpeningShape& shape);
/// Share of its border along which relief is what comes first outside it.
double relief_share(const WallCells& cells, const OpeningShape& shape);

}  // namespace jalon
