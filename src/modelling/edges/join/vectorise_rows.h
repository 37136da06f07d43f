// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/setting_rows.h"
#include "modelling/edges/join/vectorise_setting.h"

namespace jalon {

constexpr auto kContourRows = setting_rows(
    choice_row<&ContourSetting::mode>(
        "contour", "alpha|long_edge", "",
        "What counts as surface: triangles of the points with a small circumscribed circle, or "
        "those without a long edge."),
    number_row<&ContourSetting::alpha_factor>(
        "alpha_factor", 0.8, 100, "1", "",
        "alpha: largest circumradius in local point spacings; below 1 inner points become holes, "
        "much above it narrow openings close."),
    number_row<&ContourSetting::max_edge_m>(
        "max_edge_m", 0, 1000, "m", "",
        "Widest gap (full width) that counts as surface: diameter of the circle, or length of the "
        "edge. 0 = by alpha_factor, or at the knee of the sorted edge lengths, 2 to 5 spacings."),
    number_row<&ContourSetting::min_area_m2>("min_area_m2", 0, 1e9, "m2", "",
                                             "Smallest area of a connected face"),
    number_row<&ContourSetting::min_opening_area_m2>("min_opening_area_m2", 0, 1e9, "m2", "",
                                                     "Smallest area of an opening"),
    number_row<&ContourSetting::min_opening_width_m>(
        "min_opening_width_m", 0, 1e6, "m", "", "Smallest width (full, not half) of an opening"));

/// Parameter rows of every modelling method: all of them draw planes.
constexpr auto kVectoriseRows = setting_rows(
    nested_rows<&VectoriseSetting::contour, kContourRows>(),
    bool_row<&VectoriseSetting::straighten>(
        "straighten", "", "Straight edges and corners; false = the contour points as they are"),
    bool_row<&VectoriseSetting::arcs>(
        "arcs", "",
        "Curved parts of a contour become arcs where they explain it better than lines; false = "
        "lines only."),
    choice_row<&VectoriseSetting::lines>(
        "lines", "best_cuts|ransac", "",
        "Straight and curved parts of a contour: the cuts that explain its points best, or lines "
        "by "
        "RANSAC, cut at their gaps, the rest curves (Boulaassal 2010, 4.3)."),
    number_row<&VectoriseSetting::line_tolerance_m>(
        "line_tolerance_m", 0, 10, "m", "",
        "lines = ransac: half-width of the strip about a line; 0 = half the point spacing."),
    number_row<&VectoriseSetting::line_gap_m>(
        "line_gap_m", 0, 1000, "m", "",
        "lines = ransac: widest gap between neighbouring points of one straight part; 0 = 5 point "
        "spacings."),
    integer_row<&VectoriseSetting::line_min_points>(
        "line_min_points", 2, 1e6, "points", "",
        "lines = ransac: fewest contour points of a straight part."),
    integer_row<&VectoriseSetting::line_seed>("line_seed", 0, 9e15, "1", "",
                                              "lines = ransac: seed of the draws."),
    number_row<&VectoriseSetting::direction_angle_rad>(
        "direction_angle_rad", 0, 0.26, "rad", "",
        "Edges this near to vertical or horizontal are of that direction class; short ones, which "
        "noise turns, a little further."),
    number_row<&VectoriseSetting::snap_angle_rad>(
        "snap_angle_rad", 0, 0.26, "rad", "",
        "Edges this near to vertical or horizontal are made exactly so, unless an end would move "
        "by more than the point spacing; 0 = never."),
    number_row<&VectoriseSetting::reveal_depth_m>(
        "reveal_depth_m", 0, 10, "m", "",
        "How far behind and in front of a plane (full length along its normal) points are searched "
        "for the reveals that end at its edges; 0 = edges from the points of the plane alone."),
    number_row<&VectoriseSetting::tolerance_m>(
        "tolerance_m", 0, 1000, "m", "",
        "Half-width of the strip that counts as one straight edge where a contour is too ragged "
        "for straight and curved parts; 0 = 0.6 of the widest gap."),
    bool_row<&VectoriseSetting::rectangles>(
        "rectangles", "",
        "Openings with a ragged contour that fill an upright rectangle become one."));

}  // namespace jalon
