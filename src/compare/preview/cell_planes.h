// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/preview/homologous_cells.h"

namespace jalon {

/// Angle (rad, 0 ... pi / 2) between the least-squares planes of both clouds' points in a cell; NaN where either has
/// fewer than three points or all on a line. Coordinates are taken to a 2^14th of the cell.
double plane_angle(const Octree& reference, const Octree& compared, int level,
                   const CellPair& pair);

}  // namespace jalon
