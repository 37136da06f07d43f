// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/params.h"

// The rows that DepthSettings::from reads, for the operation "visibility" and the comparer's method "distance".

namespace jalon {

constexpr ParamRow kDepthHorizontalStepRow =
    number_row("depth_horizontal_step_rad", 0, 0, 1, "rad", "",
               "horizontal angular step of the reference's stations; 0: estimated from the points of each");
constexpr ParamRow kDepthVerticalStepRow = number_row("depth_vertical_step_rad", 0, 0, 1, "rad", "",
                                                      "vertical angular step; 0: estimated from the points of each");
constexpr ParamRow kDepthCellFactorRow =
    number_row("depth_cell_factor", 1.5, 0.5, 20, "1", "",
               "cell of a depth map over the angular step; 1 to 2 is usual");
constexpr ParamRow kDepthRuleRow =
    choice_row("depth_rule", "mean", "min|max|mean", "",
               "which range a cell with several points keeps: that of the nearest, of the farthest, or the mean");
constexpr ParamRow kDepthFillPassesRow =
    integer_row("depth_fill_passes", 2, 0, 100, "1", "",
                "how often cells without a point take the mean of their neighbours where four of the eight have one");
constexpr ParamRow kDepthEmptyRow = choice_row(
    "depth_empty", "auto", "auto|hides|free", "",
    "a cell that stays empty hides everything behind the scanner's window (hides) or nothing (free: the sky); auto: "
    "free when max_range_m is known, else hides");
constexpr ParamRow kDepthMarginRow =
    number_row("depth_margin_m", 0.1, 0, 1e6, "m", "",
               "how far behind the seen surface a point still counts as visible: registration and measurement errors, "
               "and the recession that counts as a change; 0.03 to 0.1 m indoors, 0.1 to 1 m outdoors");
constexpr ParamRow kDepthMarginFactorRow =
    number_row("depth_margin_factor", 1.002, 1, 10, "1", "", "the seen range times this is added to before");
constexpr ParamRow kMaxRangeRow = number_row("max_range_m", 0, 0, 1e9, "m", "",
                                             "from this distance on the scanner sees nothing; 0: unknown");
constexpr ParamRow kSecondCentreRow =
    doubles_row("second_centre_m", "0 0 0", -1e3, 1e3, "m", "",
                "receiver of a triangulation scanner in its own frame: points must be seen from both; 0 0 0: none");

// And those of a comparison alone.
constexpr ParamRow kVisibilityRow =
    choice_row("visibility", "none", "none|stations", "",
               "stations: points that the stations of the reference cloud could not have seen get no distance, and say "
               "why; none: every point is compared");
constexpr ParamRow kReferenceSpacingRow =
    bool_row("reference_spacing", false, "",
             "With visibility: also tells how far apart the reference's points lie where each point is seen, along "
             "grazing rays and across edges in depth: a distance up to half of that is no sign of a change");
constexpr ParamRow kHiddenRow =
    choice_row("hidden", "leave", "leave|vertical|occluders", "",
               "what becomes of hidden points. leave: no value; vertical: their height over the surface of the "
               "reference along hidden_direction; occluders: their distance from the points that hide them, where "
               "both have the same shape");
constexpr ParamRow kHiddenDirectionRow =
    doubles_row("hidden_direction", "0 0 1", -1e9, 1e9, "1", "", "direction for hidden = vertical, of any length");
constexpr ParamRow kHiddenRadiusRow =
    number_row("hidden_radius_m", 2, 1e-3, 1e6, "m", "",
               "for hidden = vertical: longest edge in plan of the triangles between reference points");
constexpr ParamRow kHiddenZoneRow = number_row("hidden_zone_m", 0.5, 1e-3, 1e6, "m", "",
                                               "for hidden = occluders: cell of the grid that joins hidden points to "
                                               "zones, fitted one by one");
constexpr ParamRow kHiddenShapeRatioRow =
    number_row("hidden_shape_ratio", 2, 0, 1e6, "1", "",
               "for hidden = occluders: a zone has the shape of what hides it when a rigid fit leaves at most this "
               "many spacings of the hiding points");

}  // namespace jalon
