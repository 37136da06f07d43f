// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"
#include "spatial/voxels/voxel_grid.h"

namespace jalon {

/// The occupied cells of a grid as the nodes of a front (Girardeau-Montaut 2006, 3.3.1): their points, and which of
/// the 26 cells around each are occupied too.
struct SurfaceCells {
  VoxelGrid grid;                               ///< cells in ascending order of (z, y, x)
  std::vector<std::array<int32_t, 3>> numbers;  ///< x, y, z
  std::vector<uint64_t>
      first;  ///< cell c has the neighbours around[first[c]] ... [first[c + 1] - 1]
  std::vector<uint32_t> around;  ///< ascending
  double cell_m = 0;

  size_t size() const { return numbers.size(); }
  std::span<const uint32_t> neighbours(uint32_t c) const {
    return {around.data() + first[c], static_cast<size_t>(first[c + 1] - first[c])};
  }
  std::span<const uint32_t> points(uint32_t c) const {
    return {grid.order.data() + grid.first[c], size_t{grid.first[c + 1] - grid.first[c]}};
  }
  Vec3 centroid(uint32_t c) const {
    const double* p = grid.centroids.data() + 3 * size_t{c};
    return {p[0], p[1], p[2]};
  }
  /// Whether two cells share a corner at least.
  bool touch(uint32_t a, uint32_t b) const {
    for (size_t i = 0; i < 3; ++i)
      if (std::abs(numbers[a][i] - numbers[b][i]) > 1) return false;
    return true;
  }
};

/// xyz: relative to an origin that moves with the points, so that whole-metre shifts change no bit. kLimit when the
/// cells are too small for the extent of the points. O(n).
SurfaceCells surface_cells(std::span<const double> xyz, double cell_m, Task& task);

}  // namespace jalon
