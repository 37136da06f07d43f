// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/setting_rows.h"
#include "registration/coarse/settings.h"

namespace jalon {

/// The table of method "coarse"; "automatic" has it too.
inline constexpr auto kCoarseRows = setting_rows(
    number_row<&CoarseSettings::coarse_cell_m>(
        "coarse_cell_m", 0, 1e4, "m", "",
        "Edge of the cells that both clouds are thinned to; 0 = so that the larger has about "
        "`cells` of them"),
    integer_row<&CoarseSettings::cells>(
        "cells", 500, 200000, "", "",
        "Cells of the larger cloud, for coarse_cell_m = 0; more is slower"),
    bool_row<&CoarseSettings::gravity>(
        "gravity", "",
        "z is up in both clouds, as of levelled scanners: only turns about it are found"),
    number_row<&CoarseSettings::max_turn_rad>("max_turn_rad", 0, 3.2, "rad", "",
                                              "Largest turn away from the start pose"),
    number_row<&CoarseSettings::max_shift_m>(
        "max_shift_m", 0, 1e9, "m", "",
        "Largest shift of the moving cloud's centroid away from where the start pose puts it; "
        "0 = any"),
    number_row<&CoarseSettings::ambiguous_percent>(
        "ambiguous_percent", 1, 100, "%", "",
        "Score of a clearly different pose, of the best one's, from which the result is "
        "called ambiguous"),
    number_row<&CoarseSettings::min_likeness_percent>(
        "min_likeness_percent", 0, 100, "%", "",
        "Of the salient places that come near the other cloud, the share that must look alike "
        "there; with less nothing is found (unless the clouds cover each other almost whole, or "
        "no other pose comes near: then in proportion less)"),
    number_row<&CoarseSettings::min_common_percent>(
        "min_common_percent", 0, 100, "%", "",
        "Share of the moving cloud's surface that must lie on the reference; with less "
        "nothing is found"));

}  // namespace jalon
