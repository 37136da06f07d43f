// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/setting_rows.h"
#include "segment/code_input_rows.h"
#include "segment/codes_methods.h"

namespace jalon {

namespace {

constexpr auto kTargetInputRows = code_input_rows("target_codes");

// Origins: the thesis' table of parameters; the distances are the middle of three tried on scanned buildings.
constexpr auto kTargetCodeRows = setting_rows(
    nested_rows<&TargetCodeSettings::input, kTargetInputRows>(),
    number_row<&TargetCodeSettings::patch_m>(
        "patch_m", 1e-4, 10, "m", "target_codes",
        "Radius about a target's centre whose points give its first plane: half a target."),
    number_row<&TargetCodeSettings::slab_m>(
        "slab_m", 1e-3, 100, "m", "target_codes",
        "Half-thickness of the slab about that plane in which a wall's plane is drawn."),
    integer_row<&TargetCodeSettings::wall_draws>("wall_draws", 1, 100000, "1", "target_codes",
                                                 "Planes drawn for a wall."),
    number_row<&TargetCodeSettings::wall_angle_rad>(
        "wall_angle_rad", 1e-3, 1.570796, "rad", "target_codes",
        "Largest angle between a drawn plane and that of the target; 0.157 = 9 degrees."),
    number_row<&TargetCodeSettings::wall_distance_m>(
        "wall_distance_m", 1e-4, 10, "m", "target_codes",
        "Largest distance of a wall's points from its plane: a half-thickness; corrugated sheet "
        "needs half its depth and the noise."),
    integer_row<&TargetCodeSettings::height_bins>(
        "height_bins", 1, 100000, "1", "target_codes",
        "Classes of the histogram of the walls' heights; walls end below the first empty one."),
    number_row<&TargetCodeSettings::wall_cell_m>(
        "wall_cell_m", 1e-3, 10, "m", "target_codes",
        "Edge of the cells in plan whose points must reach the height of a wall."),
    number_row<&TargetCodeSettings::least_wall_height_m>(
        "least_wall_height_m", 0, 100, "m", "target_codes",
        "Least height of a wall's points in a cell."),
    number_row<&TargetCodeSettings::door_radius_m>(
        "door_radius_m", 1e-3, 100, "m", "target_codes",
        "Radius about a door's target within which its points lie."),
    number_row<&TargetCodeSettings::window_margin_m>(
        "window_margin_m", 0, 100, "m", "target_codes",
        "How far beyond the two targets of a facade, along each axis, its windows reach; 0.1 with "
        "targets at the outer corners."),
    number_row<&TargetCodeSettings::gutter_reach_m>(
        "gutter_reach_m", 1e-3, 10, "m", "target_codes",
        "Distance in plan from a gutter's target within which its points lie."),
    number_row<&TargetCodeSettings::gutter_normal_radius_m>(
        "gutter_normal_radius_m", 1e-3, 10, "m", "target_codes",
        "Radius about a point whose neighbours give its normal."),
    number_row<&TargetCodeSettings::growing_radius_m>(
        "growing_radius_m", 1e-3, 10, "m", "target_codes",
        "How far from a gutter's point its next ones are looked for."),
    number_row<&TargetCodeSettings::growing_angle_rad>(
        "growing_angle_rad", 1e-3, 1.570796, "rad", "target_codes",
        "Largest angle between the normals of neighbours on a gutter; 0.314 = 18 degrees."),
    number_row<&TargetCodeSettings::most_normal_z>(
        "most_normal_z", 0, 1, "1", "target_codes",
        "Largest upright part of a gutter point's unit normal."),
    integer_row<&TargetCodeSettings::seed>("seed", 0, 9e18, "1", "target_codes",
                                           "Seed of the draws."));

}  // namespace

std::span<const ParamRow> target_code_rows() { return kTargetCodeRows; }

}  // namespace jalon
