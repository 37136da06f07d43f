// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/setting_rows.h"
#include "compare/visibility/settings.h"

// Groups of rows that stand in several tables: "visibility" and the comparer's method "distance".

namespace jalon {

inline constexpr auto kDepthRows = setting_rows(
    number_row<&DepthSettings::horizontal_step_rad>(
        "depth_horizontal_step_rad", 0, 1, "rad", "",
        "horizontal angular step of the reference's stations; 0: estimated from the points of "
        "each"),
    number_row<&DepthSettings::vertical_step_rad>(
        "depth_vertical_step_rad", 0, 1, "rad", "",
        "vertical angular step; 0: estimated from the points of each"),
    number_row<&DepthSettings::cell_factor>(
        "depth_cell_factor", 0.5, 20, "1", "",
        "cell of a depth map over the angular step; 1 to 2 is usual"),
    choice_row<&DepthSettings::rule>(
        "depth_rule", "min|max|mean", "",
        "which range a cell with several points keeps: that of the nearest, of the farthest, or "
        "the mean"),
    integer_row<&DepthSettings::fill_passes>(
        "depth_fill_passes", 0, 100, "1", "",
        "how often cells without a point take the mean of their neighbours where four of the "
        "eight have one"),
    choice_row<&DepthSettings::empty>(
        "depth_empty", "auto|hides|free", "",
        "a cell that stays empty hides everything behind the scanner's window (hides) or nothing "
        "(free: the sky); auto: free when max_range_m is known, else hides"),
    number_row<&DepthSettings::margin_m>(
        "depth_margin_m", 0, 1e6, "m", "",
        "how far behind the seen surface a point still counts as visible: registration and "
        "measurement errors, and the recession that counts as a change; 0.03 to 0.1 m indoors, "
        "0.1 to 1 m outdoors"),
    number_row<&DepthSettings::margin_factor>("depth_margin_factor", 1, 10, "1", "",
                                              "the seen range times this is added to before"),
    number_row<&DepthSettings::max_range_m>(
        "max_range_m", 0, 1e9, "m", "",
        "from this distance on the scanner sees nothing; 0: unknown"),
    doubles_row<&DepthSettings::second_centre_m>(
        "second_centre_m", -1e3, 1e3, "m", "",
        "receiver of a triangulation scanner in its own frame: points must be seen from both; 0 0 "
        "0: none"));

inline constexpr auto kHiddenRows = setting_rows(
    choice_row<&HiddenSettings::way>(
        "hidden", "leave|vertical|occluders", "",
        "what becomes of hidden points. leave: no value; vertical: their height over the surface "
        "of the reference along hidden_direction; occluders: their distance from the points that "
        "hide them, where both have the same shape"),
    doubles_row<&HiddenSettings::direction>("hidden_direction", -1e9, 1e9, "1", "",
                                            "direction for hidden = vertical, of any length"),
    number_row<&HiddenSettings::radius_m>(
        "hidden_radius_m", 1e-3, 1e6, "m", "",
        "for hidden = vertical: longest edge in plan of the triangles between reference points"),
    number_row<&HiddenSettings::zone_m>(
        "hidden_zone_m", 1e-3, 1e6, "m", "",
        "for hidden = occluders: cell of the grid that joins hidden points to zones, fitted one "
        "by one"),
    number_row<&HiddenSettings::shape_ratio>(
        "hidden_shape_ratio", 0, 1e6, "1", "",
        "for hidden = occluders: a zone has the shape of what hides it when a rigid fit leaves at "
        "most this many spacings of the hiding points"));

}  // namespace jalon
