// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "solid/convex_piece.h"

namespace jalon {

/// Where a point or a triangle is nearest to a piece, or deepest in it: the least signed distance of its points.
struct Contact {
  double value = 0;
  Vec3 point;     ///< of the obstacle, in the piece's frame
  Vec3 gradient;  ///< of the signed distance there
  /// A plane below the whole graph of the signed distance: distance(x) >= floor + slope . (x - point). Over the
  /// obstacle it is nowhere lower than value by more than the gap.
  double floor = 0;
  Vec3 slope;
  double gap = 0;
};

/// The least signed distance over a point (one corner) or a triangle (three). The signed distance is convex, so planes
/// that touch its graph bound it from below, and the least point of their maximum is where to look next (Kelley 1960,
/// "The cutting-plane method for solving convex programs"). Ends when value and bound are 1e-9 m apart.
Contact least_distance(const ConvexPiece& piece, std::span<const Vec3> corners);

}  // namespace jalon
