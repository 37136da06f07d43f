// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// How the points of a cloud lie about each other: over surfaces, in lines, or in heaps of noise.
struct PointSpread {
  double in_lines = 0;  ///< share of the points
  double in_one_place =
      0;  ///< share of those whose neighbours are all in their place: marks of no return
  double length_m = 0;  ///< median of the largest extent of neighbours, as a standard deviation
  double radius_m = 0;  ///< median extent of neighbours in their plane, root mean square
  double noise_m =
      0;  ///< of many neighbours from their plane: where the surface is plainest, lower quartile
};
/// By some thousand neighbourhoods of k points. O(log n).
PointSpread spread_of(const Octree& tree, uint32_t k, Task& task);

/// Whether each point lies in a line of points, in the tree's order: its neighbours and theirs spread over less than
/// kLineDimension dimensions. O(n k).
std::vector<bool> points_in_lines(const Octree& tree, uint32_t k, Task& task);

}  // namespace jalon
