// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "modelling/evidence/opening_shape.h"
#include "modelling/evidence/wall_cells.h"
#include "modelling/plane/ring_tools.h"

namespace jalon {

/// Heights over a wall's plane by cells, of the points that count as on it: in whole steps, so that threads may add in
/// any order.
class HeightSums {
 public:
  explicit HeightSums(size_t cells) : steps_(cells, 0), counts_(cells, 0) {}

  void add(size_t cell, double height_m);
  /// Means over that of the typical cell; NaN: no point.
  std::vector<float> means_m() const;

 private:
  std::vector<int64_t> steps_;
  std::vector<uint32_t> counts_;
};

/// Blinds and shutters that close an opening less behind the wall than what counts as on it. One point does not tell
/// them from the wall, the mean of a patch does. Their cells are marked as seen through.
/// 1. Patches of cells whose points lie behind the wall's in the mean, farther than noise puts them.
/// 2. Two explanations of a patch and its surroundings: a wall that bends, or a rectangle that stands back with a step
///    all about. The rectangle must leave much less unexplained.
/// 3. Recessed panels of a wall have steps too. What fills openings goes on in one (a blind that is partly down), or
///    has the like of its size in its row or column.
/// Before: marks of the cells, and heights of the points that marked them as on the plane: the wall's own, and those
/// that no segment took, as it hangs on a point whether a blind is the wall's. After: no cell of such a rectangle is
/// marked as on the plane. The rectangles, in the plane's coordinates. O(cells).
std::vector<RingBox> mark_set_back(const HeightSums& heights, const WallCells& cells,
                                   std::span<uint8_t> marks, Task& task);

/// Whether one of them lies in an opening: contours take its points for the wall's.
bool has_set_back(const WallCells& cells, const OpeningShape& opening);

}  // namespace jalon
