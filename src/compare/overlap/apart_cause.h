// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/overlap/occupied_cells.h"
#include "compare/overlap/overlap.h"

namespace jalon {

struct ApartSides {
  Box3 reference, compared;
  std::vector<Vec3> reference_points, compared_points;  ///< samples
};

/// What would bring two clouds onto each other: sets cause, axes, factor, shift. 1. degrees by their ranges; 2. axes
/// and 3. units that make the clouds meet; 4. of units and 5. of none that the boxes agree with. Of clouds that are not
/// apart only 2 and 3: those must make twice as much of them meet as does where they are, and their boxes of one size.
void find_cause(const ApartSides& sides, Task& task, CloudsOverlap& overlap);

}  // namespace jalon
