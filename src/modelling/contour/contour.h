// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"
#include "modelling/plane/vector_plane.h"

namespace jalon {

/// Which triangles of the in-plane Delaunay triangulation are surface.
enum class ContourMode : uint8_t {
  kAlpha,     ///< those with a small circumscribed circle (Edelsbrunner, Kirkpatrick & Seidel 1983)
  kLongEdge,  ///< those without a long edge (Boulaassal 2010, 4.2.3, as chains)
};

struct ContourSetting {
  ContourMode mode = ContourMode::kAlpha;
  double max_edge_m =
      0;  ///< widest gap that counts as surface; 0 = from the spacing or the edge lengths
  double alpha_factor = 2;   ///< largest circumradius in local spacings, when max_edge_m is 0
  double min_area_m2 = 0.1;  ///< of a connected piece, its openings taken off
  double min_opening_area_m2 = 0.1;
  double min_opening_width_m = 0.2;
};

/// Closed chain of points of the cloud, in plane coordinates. Outlines run anticlockwise, openings clockwise; no point
/// twice, in the chains of a piece neither: where an opening touches another chain its corner gives way by a hundredth
/// of the spacing.
using Chain = std::vector<Vec2>;

/// One connected piece of a segment.
struct ContourPiece {
  Chain outline;
  std::vector<Chain> openings;
  double area_m2 = 0;  ///< of the kept triangles
  /// One an opening, or none at all: the ring of an opening that was fitted to points, clockwise, whose chain tells no
  /// more; without corners for the others.
  std::vector<VectorRing> forms = {};
};

struct Contour {
  double spacing_m = 0;   ///< typical distance of neighbouring points
  double max_edge_m = 0;  ///< widest gap that counted as surface where the spacing is typical
  std::vector<ContourPiece> pieces;  ///< largest first
};

/// Contour of points in a plane: Delaunay triangulation without the triangles that span gaps
/// (Boulaassal 2010, 4.2.2 and 4.2.3, amended: edges with one triangle left, which
/// gives chains). Points deeper than two raster cells inside take no part, so the cost follows the
/// length of the contour: O(n log n) for the raster, then about 2 us a border point.
///
/// kAlpha lets the gap grow with the local spacing where the points lie up to twice as far apart as
/// is typical.
///
/// After: pieces by falling area, each of the least area or more, with an outline of 3 points at
/// least; openings of the least area and width or more; none for fewer than 3 points or where no
/// gap is known. Same bits for any number of threads.
///
/// foreign: tells points, by index and with the spacing found, that bound nothing; asked of border
/// points only.
using ForeignTest = std::function<bool(uint32_t point, double spacing_m)>;
Contour extract_contour(std::span<const Vec2> points, const ContourSetting& setting, Task& task,
                        const ForeignTest& foreign = {});

/// Shorter side of the rectangle with this area and perimeter; of rounder shapes the side of the square.
double equivalent_width(double area_m2, double perimeter_m);

}  // namespace jalon
