// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// A region of the plane: what the outline encloses but its holes. Corners in either order, without
/// a repeated last one.
struct PolygonWithHoles {
  std::vector<Vec2> outline;
  std::vector<std::vector<Vec2>> holes;
};

enum class SetOperation { kIntersection, kUnion, kDifference, kXor };

/// Step of the integer grid that polygons are snapped to: 0.1 mm, a tenth of what surveyors tell apart.
constexpr double kPolygonGrid_m = 1e-4;

/// Regions as sets of points, on a grid: each is the union of its polygons, which may overlap, touch or be empty. An
/// outline that crosses itself encloses what it winds round. Results are polygons with disjoint interiors, outlines
/// anticlockwise and holes clockwise; corners of the result that are no input corners are rounded
/// to the grid (Boost.Polygon,
/// Simonson 2010). Error(kLimit) for a coordinate beyond 2^27 steps (13 km on the default grid) or not finite.
/// O((n + k) log n) for n edges and k crossings.
std::vector<PolygonWithHoles> combined(SetOperation operation, std::span<const PolygonWithHoles> a,
                                       std::span<const PolygonWithHoles> b,
                                       double grid_m = kPolygonGrid_m);

/// Areas of two regions and of what they share, all of the snapped polygons, exact on the grid: a region against itself
/// gives three equal numbers.
struct SharedArea {
  double a = 0, b = 0, both = 0;  ///< square of the unit of the coordinates
};
SharedArea shared_area(std::span<const PolygonWithHoles> a, std::span<const PolygonWithHoles> b,
                       double grid_m = kPolygonGrid_m);

/// Of the union of the polygons, as snapped.
double region_area(std::span<const PolygonWithHoles> region, double grid_m = kPolygonGrid_m);

}  // namespace jalon
