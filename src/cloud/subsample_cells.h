// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cloud/cloud.h"

namespace jalon {

/// What stands for the points of a cell: their centroid, with the fields of the point nearest to
/// it (resampling, Girardeau-Montaut 2006, 4.2), or the original point nearest to the cell's
/// centre (decimation).
enum class Keep { kCentroid, kNearest };

// The new points follow each other in the order of the points whose fields they took; stations stay. Centroids of a
// regular grid for a cloud without fields and stations take nothing from its points: they follow each other cell by
// cell.

/// One point a cell of a regular grid.
Cloud one_per_voxel(const Cloud& cloud, double cell_m, Keep keep, Task& task);
/// One point an occupied cell of an octree level; level -1: the deepest with at most max_cells of them.
Cloud one_per_octree_cell(const Cloud& cloud, int level, uint64_t max_cells, Keep keep, Task& task);

}  // namespace jalon
