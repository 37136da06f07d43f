// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "compare/comparison.h"

namespace jalon {

/// Where one row of a table of changes or regions lies: the points of both epochs that changed there.
struct ChangePlace {
  size_t row = 0;  ///< of the table, from 0
  Box3 box;        ///< of what changed, with the unchanged rest of the thing
  std::vector<uint64_t> after, before;

  /// Their places.
  std::vector<Vec3> points(const Comparison& forward, const Comparison* reverse) const;
};

/// One for each of the first most rows whose box is known; a changed point belongs to the smallest box that holds it.
/// threshold_m: beyond which a point has changed; 0: as the comparison's own tests say, nothing without them. reverse
/// may be null. O(points + changed points * rows).
std::vector<ChangePlace> change_places(const Comparison& forward, const Comparison* reverse,
                                       const FieldTable& changes, double threshold_m, size_t most,
                                       Task& task);

}  // namespace jalon
