// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// Which of the 26 cells around a cell count as its neighbours: those that share a face (6), also
/// an edge (18), also a corner (26).
enum class Connectivity3 { k6, k18, k26 };

/// Connected components of the occupied cells of a regular grid, as points. Numbers 1, 2 ... by
/// falling number of points, ties by smallest point index; components of fewer than min_points get
/// 0.
struct Components {
  std::vector<uint32_t> labels;  ///< one a point
  std::vector<uint64_t>
      point_counts;  ///< [0] = points of the small ones, [label] = points of that component
  size_t count() const { return point_counts.empty() ? 0 : point_counts.size() - 1; }
};

/// Girardeau-Montaut 2006, annex E 4.1.2, with one pass over the sorted cells for each neighbour
/// direction in place of the slices: two points closer than cell_m are in one component (k26);
/// gaps above 2 sqrt(3) cell_m always part them. Cells count from origin, which should move with
/// the cloud. O(n).
Components connected_components(std::span<const double> xyz, const Vec3& origin, double cell_m,
                                Connectivity3 connectivity, uint64_t min_points, Task& task);

}  // namespace jalon
