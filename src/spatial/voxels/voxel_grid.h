// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "base/buffer.h"
#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// Points grouped by the cells of a regular grid; only occupied cells exist. Cells in ascending order of their numbers
/// (z, then y, then x counts most), the points of a cell by ascending index.
struct VoxelGrid {
  Buffer<uint32_t> order;  ///< caller's indices, cell after cell
  Buffer<uint32_t> first;  ///< size() + 1: cell v holds order[first[v]] ... order[first[v + 1] - 1]
  Buffer<double>
      centroids;  ///< 3 a cell: mean of its points, summed in index order relative to the origin
  size_t size() const { return first.empty() ? 0 : first.size() - 1; }
};

/// Cell numbers are floor((p - origin) / cell_m) on each axis, any cell size > 0: up to 42 bits an axis (kLimit
/// beyond). Take an origin that moves with the cloud (a cube's), so that whole-metre shifts give the same cells.
/// Parallel; O(n).
VoxelGrid voxel_grid(std::span<const double> xyz, const Vec3& origin, double cell_m, Task& task);
/// The lists alone, without the centroids.
VoxelGrid voxel_lists(std::span<const double> xyz, const Vec3& origin, double cell_m, Task& task);
/// The centroids alone, the same bits in the same order, without the lists. box: of all points.
Buffer<double> voxel_centroids(std::span<const double> xyz, const Box3& box, const Vec3& origin,
                               double cell_m, Task& task);

}  // namespace jalon
