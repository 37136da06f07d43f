// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "base/params.h"
#include "modelling/contour/contour.h"
#include "modelling/edges/find/straighten.h"

namespace jalon {

/// How a segment becomes a 2D vector model (facade-modelling A1-A11).
struct VectoriseSetting {
  ContourSetting contour;
  StraightenSetting straight;
  bool straighten = true;
  bool arcs = true;
  double direction_angle_rad = 0.035;
  double reveal_depth_m = 0.3;
};

/// Parameter rows of every modelling method that draws planes; a method's table joins them with its own (joined_rows).
inline constexpr std::array kVectoriseRows{
    choice_row("contour", "alpha", "alpha|long_edge", "",
               "What counts as surface: triangles of the points with a small circumscribed circle, or those without a "
               "long edge."),
    number_row("alpha_factor", 2, 0.8, 100, "1", "",
               "alpha: largest circumradius in local point spacings; below 1 inner points become holes, much above it "
               "narrow openings close."),
    number_row("max_edge_m", 0, 0, 1000, "m", "",
               "Widest gap (full width) that counts as surface: diameter of the circle, or length of the edge. 0 = by "
               "alpha_factor, or at the knee of the sorted edge lengths, 2 to 5 spacings."),
    number_row("min_area_m2", 0.1, 0, 1e9, "m2", "", "Smallest area of a connected face"),
    number_row("min_opening_area_m2", 0.1, 0, 1e9, "m2", "", "Smallest area of an opening"),
    number_row("min_opening_width_m", 0.2, 0, 1e6, "m", "", "Smallest width (full, not half) of an opening"),
    bool_row("straighten", true, "", "Straight edges and corners; false = the contour points as they are"),
    bool_row("arcs", true, "",
             "Curved parts of a contour become arcs where they explain it better than lines; false = lines only."),
    number_row("direction_angle_rad", 0.035, 0, 0.26, "rad", "",
               "Edges this near to vertical or horizontal are of that direction class; short ones, which noise turns, "
               "a little further."),
    number_row("snap_angle_rad", 0.05, 0, 0.26, "rad", "",
               "Edges this near to vertical or horizontal are made exactly so, unless an end would move by more than "
               "the point spacing; 0 = never."),
    number_row("reveal_depth_m", 0.3, 0, 10, "m", "",
               "How far behind and in front of a plane (full length along its normal) points are searched for the "
               "reveals that end at its edges; 0 = edges from the points of the plane alone."),
    number_row("tolerance_m", 0, 0, 1000, "m", "",
               "Half-width of the strip that counts as one straight edge where a contour is too ragged for straight "
               "and curved parts; 0 = 0.6 of the widest gap."),
    bool_row("rectangles", true, "", "Openings with a ragged contour that fill an upright rectangle become one."),
};

/// Reads them from a set whose table holds them.
VectoriseSetting vectorise_setting(const ParamSet& params);

/// One table of two.
template <size_t A, size_t B>
constexpr std::array<ParamRow, A + B> joined_rows(const std::array<ParamRow, A>& a, const std::array<ParamRow, B>& b) {
  std::array<ParamRow, A + B> out{};
  for (size_t i = 0; i < A; ++i) out[i] = a[i];
  for (size_t i = 0; i < B; ++i) out[A + i] = b[i];
  return out;
}

}  // namespace jalon
