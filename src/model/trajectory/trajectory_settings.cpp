// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/trajectory_settings.h"

#include "base/setting_rows.h"

namespace jalon {

namespace {

constexpr auto kTrajectoryRows = setting_rows(
    choice_row<&TrajectorySettings::axes>("axes", "enu|ned", "",
                                          "What roll, pitch and yaw mean: the vehicle's x forward, "
                                          "y left, z up and yaw anticlockwise from "
                                          "east (enu), or x forward, y right, z down and yaw "
                                          "clockwise from north (ned: Applanix, SBET)."));

}  // namespace

std::span<const ParamRow> trajectory_rows() { return kTrajectoryRows; }

}  // namespace jalon
