// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "model/trajectory/trajectory.h"

namespace jalon {

/// Lines of numbers under a line of names, by blanks, tabs, commas or semicolons: time x y z roll
/// pitch yaw, vx vy vz, and the sigmas sx sy sz, svx svy svz, sroll spitch syaw; "heading" is yaw;
/// angles are radians, or degrees where their name ends in _deg. Columns of other names are passed
/// over with a word in the log. Comments "# axes ned" and "# crs EPSG:2154" say what they name.
/// Errors name line and column.
Trajectory read_trajectory_text(const std::string& path, AxesConvention axes, Task& task);
/// The same with every digit; columns that are not known are left out.
void write_trajectory_text(const Trajectory& trajectory, const std::string& path, Task& task);

}  // namespace jalon
