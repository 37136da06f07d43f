// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

struct StraightenSetting;

/// Directed line of a contour edge, the solid on its left: points p + t direction.
struct EdgeLine {
  Vec2 point, direction{1, 0};

  /// Positive on the left.
  double distance(const Vec2& p) const { return cross(direction, p - point); }
  Vec2 foot(const Vec2& p) const { return point + direction * dot(direction, p - point); }
};

/// Least-squares line (total, 2D) of a run of contour points in their order, its cut ends and then its outliers left
/// out; snapped to horizontal or vertical; moved outward by the set-back. points: at least 2, first and last apart.
EdgeLine fit_edge_line(std::span<const Vec2> points, const StraightenSetting& setting);

/// Same direction within 5 degrees.
bool are_aligned(const EdgeLine& a, const EdgeLine& b);

/// Where they meet; nothing when the sine of their angle is below min_sine. On upright lines to the
/// last bit.
std::optional<Vec2> intersect(const EdgeLine& a, const EdgeLine& b, double min_sine);

/// Mean without the lowest and highest sixth. Reorders its argument; not empty.
double trimmed_mean(std::vector<double>& values);

}  // namespace jalon
