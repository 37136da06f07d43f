// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/changes/change_objects.h"

namespace jalon {

/// What lies beside the changed points of a thing: of the neighbours that belong to no region, which were hidden, which
/// did not change; and where some did not, at its borders, how far the changed surface leaves the other epoch's along
/// it: a dent does, a box that stands on a floor rises across.
struct Beside {
  size_t asked = 0, hidden = 0, same = 0;
  size_t borders = 0;
  double along = 0;  ///< sum of cosines between both surfaces at the borders

  /// 0 ... 1; of few border points nothing is sure.
  double border_along() const;
};

/// Asks a sample of the points. near_m: what is farther from the other epoch does not leave it here, it lies over it.
void add_beside(const Epoch& epoch, const Epoch& other, const std::vector<uint32_t>& points,
                double near_m, Task& task, Beside& out);

}  // namespace jalon
