// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/setting_rows.h"

namespace jalon {

/// What of the scene "yard" is built.
enum class YardZone { kComplete, kFacades, kAll };

/// Of the scene "yard"; the table of the rows says what each member means.
struct YardSettings {
  YardZone zone = YardZone::kComplete;
  bool flush_doors = false, corner_targets = false, missing_target = false;
  double gutter_shift_m = 0;
  double survey_noise_m = 0.002, georeference_m = 0.005;
};

inline constexpr auto kYardRows = setting_rows(
    choice_row<&YardSettings::zone>(
        "zone", "complete|facades|all", "yard",
        "complete: one building from all sides; facades: those of three others that face the yard, "
        "with six gutters; all: the four buildings, all sides"),
    bool_row<&YardSettings::flush_doors>(
        "flush_doors", "yard", "the doors of the building with gutters are flush with its walls"),
    bool_row<&YardSettings::corner_targets>(
        "corner_targets", "yard",
        "targets of windows stick at the outer corners of the end windows, not on their panes"),
    bool_row<&YardSettings::missing_target>("missing_target", "yard",
                                            "one door has no target in the list"),
    number_row<&YardSettings::gutter_shift_m>(
        "gutter_shift_m", 0, 1, "m", "yard",
        "shift of the surveyed centre of one gutter from its place"),
    number_row<&YardSettings::survey_noise_m>("survey_noise_m", 0, 1, "m", "yard",
                                              "standard deviation of each coordinate of a surveyed "
                                              "point"),
    number_row<&YardSettings::georeference_m>(
        "georeference_m", 0, 1, "m", "yard",
        "shift of the whole survey off the cloud, in a direction by the seed"));

}  // namespace jalon
