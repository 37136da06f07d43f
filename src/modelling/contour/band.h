// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/task.h"
#include "modelling/contour/boundary_rings.h"

namespace jalon {

/// The points of a segment that can lie on a contour.
struct ContourBand {
  std::vector<Vec2> points;
  std::vector<uint8_t> is_inner;  ///< in a raster cell whose eight neighbours are all occupied
  std::vector<float> spacing_m;   ///< of the points about it: root of the occupied area a point
};

/// Leaves out the points of cells that are inner and have only inner neighbours, those that lie in
/// a string, and those that are `foreign` (by index in points; empty: none).
///
/// Before: points not empty; cell_m and spacing_m above 0. After: the members are as long as each
/// other, by cell, in one by index; foreign was asked of these and of no point deep inside. O(n log
/// n).
ContourBand contour_band(std::span<const Vec2> points, double cell_m, double spacing_m,
                         const std::function<bool(uint32_t)>& foreign, Task& task);

/// Delaunay triangles of the band, anticlockwise. Those among inner cells span the points left out:
/// the functions below keep them whatever their size.
std::vector<Triangle2> all_triangles(const ContourBand& band, Task& task);
/// Those without an edge longer than max_edge_m.
std::vector<Triangle2> short_triangles(const ContourBand& band, double max_edge_m, Task& task);
/// Those with a circumradius up to radius_m; where the points lie further or less far apart than typical_m, in
/// proportion (within limits). typical_m = 0: radius_m everywhere.
std::vector<Triangle2> alpha_triangles(const ContourBand& band, double radius_m, double typical_m,
                                       Task& task);

}  // namespace jalon
