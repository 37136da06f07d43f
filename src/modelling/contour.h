// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

struct ContourSetting {
  double max_edge_m = 0;       ///< triangles with a longer edge are dropped; 0 = edge_factor x spacing
  double edge_factor = 4;
  double min_area_m2 = 0.1;    ///< of a connected piece, its openings taken off
  double min_opening_area_m2 = 0.1;
  double min_opening_width_m = 0.2;
};

/// Closed chain of points of the cloud, in plane coordinates. Outlines run anticlockwise, openings clockwise; no point
/// twice.
using Chain = std::vector<Vec2>;

/// One connected piece of a segment.
struct ContourPiece {
  Chain outline;
  std::vector<Chain> openings;
  double area_m2 = 0;  ///< of the kept triangles
};

struct Contour {
  double spacing_m = 0;   ///< typical distance of neighbouring points
  double max_edge_m = 0;  ///< what was used
  std::vector<ContourPiece> pieces;  ///< largest first
};

/// Typical spacing: sqrt of the area a point, from the distance of the 8th neighbour of up to 1000 sampled points; the
/// upper quartile of them, so that the sparser parts of the segment count. 0 for fewer than 9 points or when all are
/// equal.
double typical_spacing(std::span<const Vec2> points, Task& task);

/// Contour of points in a plane: Delaunay triangulation without the triangles that have a long edge (Boulaassal 2010,
/// 4.2.2-4.2.3, as amended in the table of failure 5: edges with one triangle, which gives chains). Points deeper than
/// two raster cells inside take no part, so the cost follows the length of the contour: O(n log n) for the raster, then
/// about 2 us a border point.
Contour extract_contour(std::span<const Vec2> points, const ContourSetting& setting, Task& task);

/// Shorter side of the rectangle with this area and perimeter; of rounder shapes the side of the square.
double equivalent_width(double area_m2, double perimeter_m);

}  // namespace jalon
