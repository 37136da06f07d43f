// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "modelling/evaluation/index_rows.h"
#include "modelling/evaluation/model_evaluation.h"

namespace jalon {

namespace {

using S = ModelEvaluationSettings;
constexpr double kRightAngle = std::numbers::pi / 2;

constexpr auto kRows = setting_rows(
    choice_row<&S::mode>(
        "mode", "absolute|relative", "",
        "absolute: against an independent survey, the whole deviation counts; relative: against a "
        "reference drawn on the same points, a shift common to the model (registration, datum) is "
        "taken off first"),
    nested_rows<&S::indices, kIndexRows>(),
    choice_row<&S::compare>(
        "compare", "faces|openings", "",
        "faces with their openings taken off, or the openings alone, each a polygon"),
    choice_row<&S::group>(
        "group", "face|plane", "",
        "face: one to one; plane: all faces of a plane together, for models that cut it "
        "differently. A mesh, and what it is compared with, always goes by plane."),
    string_row<&S::classes>("classes", "",
                            "Classes of parts whose faces count, separated by commas; empty: all"),
    string_row<&S::ignored_classes>(
        "ignored_classes", "", "Classes of parts whose faces are left out, separated by commas"),
    number_row<&S::min_area_m2>("min_area_m2", 0, 1e9, "m2", "",
                                "Smaller faces are left out, on both sides"),
    number_row<&S::angle_tolerance_rad>(
        "angle_tolerance_rad", 0, kRightAngle, "rad", "",
        "Largest angle between the planes of a pair; normals may point either way"),
    number_row<&S::distance_tolerance_m>(
        "distance_tolerance_m", 0, 1e6, "m", "",
        "Largest distance of an automatic face's middle from the plane of its reference, to either "
        "side"),
    number_row<&S::min_iou>("min_iou", 0, 1, "1", "",
                            "Faces that overlap less (intersection over union) are no pair: chance "
                            "contacts stay unmatched"),
    number_row<&S::contour_tolerance_m>(
        "contour_tolerance_m", 0, 1e6, "m", "",
        "Distance up to which a place of a contour counts as right: a radius"),
    number_row<&S::contour_step_m>("contour_step_m", 1e-4, 1e6, "m", "",
                                   "Distance between the places of a contour looked at"),
    number_row<&S::vertex_tolerance_m>("vertex_tolerance_m", 0, 1e6, "m", "",
                                       "Largest distance of homologous vertices: a radius"),
    number_row<&S::corner_angle_rad>(
        "corner_angle_rad", 0, std::numbers::pi, "rad", "",
        "Least turn of a border at a corner that counts as a vertex; ends of arcs always do, and "
        "all corners of a mesh's triangles"));

}  // namespace

std::span<const ParamRow> model_evaluation_rows() { return kRows; }

}  // namespace jalon
