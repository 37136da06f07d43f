// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/setting_rows.h"
#include "segment/code_input_rows.h"
#include "segment/codes_methods.h"

namespace jalon {

namespace {

constexpr auto kCodeInputRows = code_input_rows("survey_codes");

// Origins: the thesis' table of thresholds, each the middle of three tried on scanned buildings.
constexpr auto kSurveyCodeRows = setting_rows(
    nested_rows<&SurveyCodeSettings::input, kCodeInputRows>(),
    number_row<&SurveyCodeSettings::pipe_margin_m>(
        "pipe_margin_m", 0, 10, "m", "survey_codes",
        "How far outside a pipe's measured radius its points may lie."),
    number_row<&SurveyCodeSettings::outward_m>(
        "outward_m", 0, 10, "m", "survey_codes",
        "How far outside a building's outline its points may lie."),
    number_row<&SurveyCodeSettings::inward_m>(
        "inward_m", 0, 100, "m", "survey_codes",
        "Depth of a building's walls behind the outline; deeper points are what was seen through "
        "panes."),
    number_row<&SurveyCodeSettings::height_margin_m>(
        "height_margin_m", 0, 10, "m", "survey_codes",
        "How far below the low point and above the highest corner a building's points may lie."),
    number_row<&SurveyCodeSettings::opening_margin_m>(
        "opening_margin_m", 0, 10, "m", "survey_codes",
        "How far beside its corners an opening's points may lie, along each axis."));

}  // namespace

std::span<const ParamRow> survey_code_rows() { return kSurveyCodeRows; }

}  // namespace jalon
