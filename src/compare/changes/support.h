// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/plane.h"

namespace jalon {

/// A plane on or before which things change: floor, ground, wall.
struct Support {
  Plane plane;
  double tolerance_m = 0;  ///< half-thickness of what belongs to it
  Vec3 axis_u, axis_v;     ///< in the plane
  double width_u_m = 0, width_v_m = 0;
  /// Larger than a thing along both its axes.
  bool goes_beyond(const Box3& thing) const;
  bool holds(const Vec3& p) const { return std::abs(plane.distance(p)) <= tolerance_m; }
};

/// Planes among the unchanged points around a change that go on beyond it, the largest first: seeded draws of three
/// points (Fischler & Bolles 1981), then least squares. What ends with the change (the unchanged top of a box that was
/// pushed) is no support. Of very many points every support_step-th is enough.
size_t support_step(size_t unchanged);
std::vector<Support> find_supports(std::span<const Vec3> unchanged, const Box3& change,
                                   double tolerance_m, uint64_t seed);

}  // namespace jalon
