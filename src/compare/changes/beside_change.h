// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/changes/change_objects.h"

namespace jalon {

/// What lies beside the changed points of a thing: of the neighbours that belong to no region, which were hidden, which
/// did not change; and where some did not, at its borders, how far the changed surface leaves the other epoch's along
/// it: a dent does, a box that stands on a floor rises across. And what the other epoch has nearest to it: the surface
/// that gave way is gone or out of sight, and the new one faces as it did.
struct Beside {
  size_t asked = 0, hidden = 0, same = 0;
  size_t borders = 0;
  double along = 0;  ///< sum of cosines between both surfaces at the borders
  size_t measured = 0, gone = 0;
  double facing = 0, facing_gone = 0;  ///< sums of cosines, of all and where it is gone

  /// 0 ... 1; of few points nothing is sure.
  double border_along() const;
  double gone_share() const;
  double facing_share() const;
  double facing_gone_share() const;
};

/// Asks a sample of the points. near_m: what is farther from the other epoch does not leave it here, it lies over it.
void add_beside(const Epoch& epoch, const Epoch& other, const std::vector<uint32_t>& points,
                double near_m, Task& task, Beside& out);

}  // namespace jalon
