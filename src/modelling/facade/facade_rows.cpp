// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/setting_rows.h"
#include "modelling/edges/join/vectorise_rows.h"
#include "modelling/facade/facade.h"

namespace jalon {

namespace {

constexpr auto kGroupRows = setting_rows(
    number_row<&GroupSetting::min_wall_area_m2>(
        "min_wall_area_m2", 0, 1e9, "m2", "",
        "Smallest area of a wall, its openings not taken off; smaller upright planes are elements"),
    number_row<&GroupSetting::min_wall_width_m>(
        "min_wall_width_m", 0, 1e6, "m", "",
        "Smallest width (full, not half) of a wall; narrower upright planes are sides of posts and "
        "reveals"),
    number_row<&GroupSetting::min_facade_share>(
        "min_facade_share", 0, 1, "1", "",
        "Smallest area of a facade's main wall, as a share of the largest wall's; smaller ones are "
        "elements"),
    number_row<&GroupSetting::min_facade_height_m>("min_facade_height_m", 0, 1000, "m", "",
                                                   "Smallest height of a facade's main wall"),
    number_row<&GroupSetting::facade_depth_m>(
        "facade_depth_m", 0, 1000, "m", "",
        "Parallel walls belong to a facade up to this distance before and behind its main wall"),
    number_row<&GroupSetting::facade_gap_m>("facade_gap_m", 0, 1000, "m", "",
                                            "... and up to this gap beside the walls it has"));

constexpr auto kSurveyRows = setting_rows(
    number_row<&SurveySetting::min_depth_m>(
        "min_depth_m", 0.001, 10, "m", "",
        "Nearer to the plane of a wall than this distance counts as on it: least depth of joinery"),
    number_row<&SurveySetting::max_depth_m>(
        "max_depth_m", 0.01, 100, "m", "", "Largest depth of joinery behind the plane of its wall"),
    number_row<&SurveySetting::front_m>(
        "front_m", 0, 10, "m", "",
        "What fills an opening may stand up to this distance before the plane of the wall"));

constexpr auto kJointRows = setting_rows(
    bool_row<&JointSetting::enabled>(
        "joints", "", "Edges near another plane are drawn to the line in which both planes meet"),
    number_row<&JointSetting::gap_m>(
        "joint_gap_m", 0, 100, "m", "",
        "Largest gap between an edge and that line; 0 = two spacings of the plane's points"));

constexpr auto kNotchRows = setting_rows(number_row<&NotchSetting::min_height_m>(
    "min_door_height_m", 0.1, 100, "m", "",
    "Least height of a notch in the lower border of a wall that counts as an opening"));
constexpr auto kDoorRows = nested_rows<&GroupSetting::notch, kNotchRows>();

constexpr auto kPatternRows = setting_rows(
    bool_row<&PatternSetting::enabled>(
        "patterns", "",
        "Repeated openings: badly measured ones take the form of the best one of their kind, and "
        "one missing in a regular grid is added where no point shows a wall; both are marked as "
        "copies"),
    number_row<&PatternSetting::size_tolerance_m>(
        "pattern_tolerance_m", 0, 1, "m", "",
        "Openings whose widths and heights (full) differ by no more are of one size; more where "
        "their own standard deviations say so"),
    number_row<&PatternSetting::least_coverage>(
        "pattern_coverage", 0, 1, "1", "",
        "Openings with a smaller share of measured outline are badly measured: they are no pattern "
        "and may become a copy"),
    number_row<&PatternSetting::least_occupancy>(
        "pattern_occupancy", 0, 1, "1", "",
        "Rows and columns make a regular grid when so large a share of their crossings that can be "
        "seen is taken"));

constexpr auto kEvidenceRows = setting_rows(bool_row<&PlanSetting::by_evidence>(
    "evidence", "",
    "Walls and openings by what the cloud shows at each place of a wall's plane: pieces of a wall "
    "are one, and what nobody measured is no wall; else by the contours of the planes"));
constexpr auto kWallRows = setting_rows(nested_rows<&PlanSetting::group, kGroupRows>(),
                                        nested_rows<&PlanSetting::survey, kSurveyRows>());
constexpr auto kFillRows = setting_rows(
    choice_row<&FillSetting::fill>(
        "fill", "never|small|outline", "",
        "What of a wall is drawn where nothing was measured: nothing of it, what is small, or all "
        "within its outline; what is not drawn is a hole of part class no_data"),
    number_row<&FillSetting::small_spacings>(
        "fill_spacings", 0, 1e6, "spacings", "",
        "Longer side of what is small, in spacings of the wall's points"));
constexpr auto kClassRows = setting_rows(number_row<&ClassSetting::min_confidence>(
    "min_class_confidence", 0, 1, "1", "",
    "Least probability of the class of an opening (window, door, gateway, shop_front, vent, "
    "recess); below it is an \"opening\""));
constexpr auto kOpeningRows = setting_rows(nested_rows<&PlanSetting::group, kDoorRows>(),
                                           nested_rows<&PlanSetting::patterns, kPatternRows>(),
                                           nested_rows<&PlanSetting::classes, kClassRows>(),
                                           nested_rows<&PlanSetting::fill, kFillRows>());

constexpr auto kThicknessRows = setting_rows(number_row<&ExtrusionSettings::thickness_m>(
    "thickness_m", 0, 100, "m", "",
    "Thickness (full) of walls that become solids; 0 = the median depth of the facade's "
    "openings"));
constexpr auto kSolidsRows = setting_rows(bool_row<&FacadeSettings::solids>(
    "solids", "", "Walls with thickness_m as closed solids; arcs become chords within 1 mm"));

constexpr auto kExtrusionRows =
    setting_rows(nested_rows<&ExtrusionSettings::plan, kEvidenceRows>(),
                 nested_rows<&ExtrusionSettings::vectorise, kVectoriseRows>(),
                 nested_rows<&ExtrusionSettings::plan, kWallRows>(),
                 nested_rows<&ExtrusionSettings::joints, kJointRows>(),
                 nested_rows<&ExtrusionSettings::plan, kOpeningRows>(), kThicknessRows);

constexpr auto kFacadeRows =
    setting_rows(nested_rows<&FacadeSettings::walls, kExtrusionRows>(), kSolidsRows);

constexpr auto kCellSearchRows = setting_rows(
    number_row<&OpeningSearch::edge_length_m>(
        "edge_length_m", 0.01, 100, "m", "",
        "Least length of a wall's ends in one line, upright or level, for the line to part the "
        "wall into cells"),
    number_row<&OpeningSearch::wall_share>(
        "wall_share", 0, 1, "1", "",
        "Share of a cell that is wall, by points; with less the cell is an opening"));
constexpr auto kCellPlanSearchRows = nested_rows<&PlanSetting::openings, kCellSearchRows>();
constexpr auto kCellPlanRows = setting_rows(
    kCellPlanSearchRows, kWallRows, nested_rows<&PlanSetting::group, kDoorRows>(),
    nested_rows<&PlanSetting::classes, kClassRows>(), nested_rows<&PlanSetting::fill, kFillRows>());
constexpr auto kCellWallRows =
    setting_rows(nested_rows<&ExtrusionSettings::plan, kCellPlanRows>(),
                 nested_rows<&ExtrusionSettings::vectorise, kVectoriseRows>(),
                 nested_rows<&ExtrusionSettings::joints, kJointRows>(), kThicknessRows);
constexpr auto kCellRows =
    setting_rows(nested_rows<&FacadeSettings::walls, kCellWallRows>(), kSolidsRows);

}  // namespace

std::span<const ParamRow> cell_decomposition_rows() { return kCellRows; }
std::span<const ParamRow> facade_rows() { return kFacadeRows; }
std::span<const ParamRow> extrusion_rows() { return kExtrusionRows; }

}  // namespace jalon
