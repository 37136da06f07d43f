// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/network_settings.h"

#include "base/setting_rows.h"
#include "registration/targets/snooping_rows.h"

namespace jalon {

namespace {

using S = NetworkSettings;

constexpr auto kRowsOfNetworks = setting_rows(
    choice_row<&S::angle_unit>("angle_unit", "gon|degree|radian", "",
                               "Unit of directions and zenith angles in the list."),
    choice_row<&S::datum>(
        "datum", "constrained|free", "",
        "constrained: fixed and weak points hold the network. free: its own shape "
        "alone, all points by inner constraints, none fixed or weak."),
    number_row<&S::sigma_direction_rad>("sigma_direction_rad", 1e-9, 0.1, "rad", "",
                                        "Standard deviation of a direction that has none of its "
                                        "own."),
    number_row<&S::sigma_zenith_rad>("sigma_zenith_rad", 1e-9, 0.1, "rad", "",
                                     "Standard deviation of a zenith angle that has none of its "
                                     "own."),
    number_row<&S::sigma_distance_m>("sigma_distance_m", 1e-6, 10, "m", "",
                                     "Standard deviation of a distance that has none of its own: "
                                     "constant part."),
    number_row<&S::sigma_distance_ppm>("sigma_distance_ppm", 0, 1000, "1e-6", "",
                                       "Part of it that grows with the distance, added linearly."),
    number_row<&S::sigma_centring_m>("sigma_centring_m", 0, 1, "m", "",
                                     "Standard deviation of the instrument's place over its point, "
                                     "in x and in y, once a setup."),
    number_row<&S::sigma_target_centring_m>("sigma_target_centring_m", 0, 1, "m", "",
                                            "Standard deviation of a target's place over its "
                                            "point, in x and in y, once for each setup that "
                                            "sights it."),
    number_row<&S::sigma_height_m>("sigma_height_m", 0, 1, "m", "",
                                   "Standard deviation of the instrument's height, once a setup."),
    number_row<&S::sigma_target_height_m>("sigma_target_height_m", 0, 1, "m", "",
                                          "Standard deviation of a target's height, once for each "
                                          "setup that sights it."),
    number_row<&S::refraction>(
        "refraction", -5, 5, "1", "",
        "Coefficient of refraction: curvature of the sights over that of the "
        "Earth."),
    number_row<&S::earth_radius_m>("earth_radius_m", 1e6, 1e12, "m", "",
                                   "Radius of the Earth; 1e12 is a plane."),
    number_row<&S::scale>("scale", 0.9, 1.1, "1", "",
                          "A length in the coordinates over its length in the field: projection "
                          "and height."),
    nested_rows<&S::snooping, kSnoopingRows>(),
    bool_row<&S::reject>("reject", "",
                         "Leave the worst outlier out and adjust again, until there is none."),
    number_row<&S::tolerance_m>("tolerance_m", 1e-12, 0.1, "m", "",
                                "The adjustment has converged when no coordinate moves by more."),
    integer_row<&S::most_iterations>("most_iterations", 1, 1000, "", "", "Steps at most."));

}  // namespace

std::span<const ParamRow> network_rows() { return kRowsOfNetworks; }

}  // namespace jalon
