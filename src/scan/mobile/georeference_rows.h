// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "base/setting_rows.h"
#include "scan/mobile/georeference.h"

namespace jalon {

/// The rows of operation "georeference", and of scanners that georeference what they measure.
inline constexpr double kTurn_rad = 2 * std::numbers::pi;
inline constexpr auto kGeoreferenceRows = setting_rows(
    doubles_row<&GeoreferenceSettings::mirror_offset_m>(
        "mirror_offset_m", -1e3, 1e3, "m", "",
        "Offset of the beams' origin in the scanner's frame: x, y, z."),
    doubles_row<&GeoreferenceSettings::boresight_rad>(
        "boresight_rad", -kTurn_rad, kTurn_rad, "rad", "",
        "Roll, pitch and yaw of the scanner in the vehicle's frame."),
    choice_row<&GeoreferenceSettings::boresight_order>(
        "boresight_order", "zyx|xyz", "",
        "Of the boresight rotation: Rz(yaw) Ry(pitch) Rx(roll), or Rx(roll) Ry(pitch) Rz(yaw)."),
    doubles_row<&GeoreferenceSettings::lever_arm_m>(
        "lever_arm_m", -1e3, 1e3, "m", "",
        "Offset of the scanner from the inertial unit, in the vehicle's frame: x, y, z."),
    bool_row<&GeoreferenceSettings::covariances>("covariances", "",
                                                 "Give each point its covariance from the sigmas."),
    number_row<&GeoreferenceSettings::sigma_range_m>("sigma_range_m", 0, 10, "m", "",
                                                     "Standard deviation of a range."),
    number_row<&GeoreferenceSettings::sigma_theta_rad>("sigma_theta_rad", 0, 1, "rad", "",
                                                       "Standard deviation of theta."),
    number_row<&GeoreferenceSettings::sigma_phi_rad>("sigma_phi_rad", 0, 1, "rad", "",
                                                     "Standard deviation of phi."),
    doubles_row<&GeoreferenceSettings::sigma_mirror_m>(
        "sigma_mirror_m", 0, 10, "m", "", "Standard deviations of the mirror offset: x, y, z."),
    doubles_row<&GeoreferenceSettings::sigma_boresight_rad>(
        "sigma_boresight_rad", 0, 1, "rad", "",
        "Standard deviations of the boresight: roll, pitch, yaw."),
    doubles_row<&GeoreferenceSettings::sigma_lever_arm_m>(
        "sigma_lever_arm_m", 0, 10, "m", "", "Standard deviations of the lever arm: x, y, z."));

}  // namespace jalon
