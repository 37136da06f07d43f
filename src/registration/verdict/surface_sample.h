// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "registration/surface/planes.h"

namespace jalon {

// Legend of the verdict, for all files of this folder.
//
//   surface   SurfacePlanes of a cloud; places are in its frame, from the origin of its octree's cube
//   surfel    a place of it with its normal, one of some thousand
//   station   where a scanner stood; its sight: SightMap
//   with, of  the surfels of one cloud are held against the other cloud; T_with_of

struct Surfel {
  Vec3 place, normal;     ///< normal of either sign
  double radius_m = 0;    ///< of the neighbours that its plane goes through
  uint32_t position = 0;  ///< in the surface
  int sight = -1;         ///< of the station that saw it; -1: not known
};

/// Flat points of the deepest level with at most so many cells, up to three a cell, one for each axis that they face.
std::vector<Surfel> sample_surface(const SurfacePlanes& surface, size_t most_cells, Task& task);

}  // namespace jalon
