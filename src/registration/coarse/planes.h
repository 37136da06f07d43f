// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "geometry/plane.h"
#include "registration/coarse/surface.h"

namespace jalon {

/// All flat parts of a surface that lie in one plane. The sign of the normal means nothing.
struct CoarsePlane {
  Plane plane;       ///< in the surface's frame
  size_t cells = 0;  ///< its area, in cells
};

/// Planes by growing flat regions over neighbouring cells (surface growing, Vosselman et al. 2004),
/// coplanar regions as one. The segmenters of the room segment find more and finer ones in every
/// point; a start pose needs the large ones, of the thinned surface, in a fraction of a second.
///
/// Before: normals and variation are set. After: the largest first, at most `most`, each of 20
/// cells or more; no two of them coplanar.
std::vector<CoarsePlane> coarse_planes(const CoarseSurface& surface, size_t most, Task& task);

}  // namespace jalon
