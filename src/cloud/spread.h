// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
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
/// Whether a point lies in a line of points: its neighbours' neighbours, as many of each, spread over less than
/// kLineDimension dimensions. neighbours: by positions, of knn_positions(). theirs: room for these.
bool lies_in_line(const Octree& tree, std::span<const Neighbour> neighbours,
                  std::vector<Neighbour>& theirs);
/// By some thousand neighbourhoods of k points. O(log n).
PointSpread spread_of(const Octree& tree, uint32_t k, Task& task);

/// lies_in_line() of each point, in the tree's order. O(n k).
std::vector<bool> points_in_lines(const Octree& tree, uint32_t k, Task& task);

}  // namespace jalon
