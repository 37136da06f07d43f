// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "modelling/contour/boundary_rings.h"

namespace jalon {

// Contour points by long edges (Boulaassal 2010, 4.2.3).

/// The automatic threshold lies between these spacings: on a regular grid the ordinary edges reach 1.42, and gaps wider
/// than 5 are openings.
constexpr double kLeastSpacings = 2, kMostSpacings = 5;

/// Length of every edge of the triangles, each once, ascending: the curve that the threshold is read from. O(t log t).
std::vector<double> edge_lengths(std::span<const Vec2> points,
                                 std::span<const Triangle2> triangles);

/// Threshold at the knee of that curve: where it lies farthest below the chord from its first length to 10 spacings,
/// but 2 to 5 spacings. 3 spacings when there are no edges.
double long_edge_threshold(std::span<const double> lengths, double spacing_m);

/// End points of the edges longer than threshold_m: outer and inner contours together. After:
/// indices of points, ascending, none twice. O(t log t).
std::vector<uint32_t> long_edge_points(std::span<const Vec2> points,
                                       std::span<const Triangle2> triangles, double threshold_m);

}  // namespace jalon
