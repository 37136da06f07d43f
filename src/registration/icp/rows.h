// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "base/setting_rows.h"
#include "registration/icp/settings.h"

namespace jalon {

/// The table of method "icp"; "automatic" has it too.
inline constexpr auto kIcpRows = setting_rows(
    choice_row<&IcpSettings::metric>(
        "metric", "point_to_point|point_to_plane|plane_to_plane", "",
        "What is made small: distances of points (Besl & McKay 1992), of points from local "
        "planes (Chen & Medioni 1992), or of local planes from each other (Segal et al. 2009)"),
    choice_row<&IcpSettings::kernel>(
        "kernel", "none|tukey|cauchy|huber", "",
        "Weight of large residuals; its scale is the median of their absolute values"),
    number_row<&IcpSettings::max_distance_m>(
        "max_distance_m", 0, 1e6, "m", "",
        "Residuals above this make no pair at the start; it shrinks by a fifth each "
        "iteration, down to three times the noise; 0 = three times the median distance at the "
        "start"),
    number_row<&IcpSettings::min_distance_m>(
        "min_distance_m", 0, 1e6, "m", "",
        "Where that distance stops shrinking; 0 = at three times the noise of both clouds"),
    number_row<&IcpSettings::trim_percent>(
        "trim_percent", 0, 90, "%", "",
        "Share of the pairs, those with the largest residuals, left out"),
    number_row<&IcpSettings::max_angle_rad>("max_angle_rad", 0, std::numbers::pi / 2, "rad", "",
                                            "Largest angle between the normals of a pair"),
    number_row<&IcpSettings::min_overlap_percent>(
        "min_overlap_percent", 0, 100, "%", "",
        "Share of the moving points that must keep a pair; with less the registration stops "
        "and says so"),
    number_row<&IcpSettings::cell_m>(
        "cell_m", 0, 1e6, "m", "",
        "Edge of cubes that are thinned to one point each before all else; 0 = none, but "
        "where points lie in lines too far apart for their neighbours to span a plane, as "
        "those of spinning scanners do"),
    integer_row<&IcpSettings::k>("k", 6, 256, "points", "",
                                 "Neighbours of a local plane, the point itself included"),
    integer_row<&IcpSettings::max_iterations>("max_iterations", 1, 10000, "", "",
                                              "Most iterations, all levels together"),
    bool_row<&IcpSettings::coarse_to_fine>(
        "coarse_to_fine", "",
        "Begin with a few thousand points of both clouds; false: all from the start"));

}  // namespace jalon
