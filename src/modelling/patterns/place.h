// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "modelling/walls/facade_parts.h"

namespace jalon {

/// A rotation about a point of the plane and a shift.
struct Motion2 {
  Vec2 pivot, shift;
  double turn_rad = 0;

  Vec2 point(const Vec2& p) const;
  /// The point that this one was moved from.
  Vec2 origin_of(const Vec2& p) const;
};
VectorRing moved(const VectorRing& ring, const Motion2& motion);

/// A form laid onto border points of the wall.
struct Placement {
  Motion2 motion;
  double residual_m = 0;
  double cost_m2 = 0;  ///< mean square distance of all border points, at most the reach of each
  size_t support = 0;  ///< border points that lie where the form's border should be
  /// Of the border points beside the left, right, lower and upper side of the form: how many, and their mean distance
  /// outward from where they should be.
  std::array<size_t, 4> sides{};
  std::array<double, 4> offsets_m{};
};

/// Iterative closest points with a rigid 2D Procrustes step (Besl & McKay 1992; Kabsch 1976): the motion of the form
/// (anticlockwise) that brings border points to this distance outside it. Starts from the shift; points farther than
/// reach_m from where they should be count no more in the end. Turns only where it may and the points prove it.
/// O(iterations x points x corners).
Placement place_on_border(std::span<const Vec2> form, double set_back_m,
                          std::span<const Vec2> border, const Vec2& start, double reach_m,
                          bool may_turn);

/// Mean square distance of border points from where the form itself, moved nowhere, says that they should lie at the
/// set-back that suits them best; at most the reach of each.
double cost_in_place(std::span<const Vec2> form, std::span<const Vec2> border, double reach_m);

/// Mean signed distance of points outside (positive) and inside the form.
double mean_distance(std::span<const Vec2> form, std::span<const Vec2> points);

/// Cells of the map well inside a form.
struct CellCount {
  std::array<size_t, 4> of{};  ///< by WallCell
  size_t all() const { return of[0] + of[1] + of[2] + of[3]; }
  double share(WallCell cell) const {
    return all() > 0
               ? static_cast<double>(of[static_cast<size_t>(cell)]) / static_cast<double>(all())
               : 0;
  }
};
/// Cells whose middle lies inside the form and this far from its border.
CellCount count_cells(const WallMap& map, std::span<const Vec2> form, double margin_m);

}  // namespace jalon
