// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// What the caller has made of its parameters and of the spacing of the points.
struct StraightenSetting {
  double tolerance_m = 0;     ///< half-width of the strip that counts as one straight edge
  double max_edge_m = 0;      ///< of the triangulation: corners may be cut by so much
  double snap_angle_rad = 0;  ///< edges this near to horizontal or vertical become so
  double set_back_m = 0;      ///< points end this far inside the true edge on average
};

using Polygon = std::vector<Vec2>;

/// Straight edges for a chain of contour points with the solid on its left (Boulaassal 2010, 4.3, for straight parts):
/// Douglas-Peucker runs, a least-squares line a run, corners as intersections of neighbouring lines. Never crosses
/// itself: where the lines would, the Douglas-Peucker polygon comes back, and at worst the chain. Turns the same way
/// round as the chain.
Polygon straightened(std::span<const Vec2> chain, const StraightenSetting& setting);

/// The Douglas-Peucker polygon alone.
Polygon thinned(std::span<const Vec2> chain, double tolerance_m);

/// The axis-parallel rectangle that an opening's chain (clockwise) fills, as 4 corners clockwise; empty when the chain
/// has another form.
Polygon fitted_rectangle(std::span<const Vec2> chain, const StraightenSetting& setting);

}  // namespace jalon
