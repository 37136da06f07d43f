// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cloud/cloud.h"

namespace jalon {

/// Where the scanners of a cloud without stations stood, by the order of its points: a tripod scanner writes upright
/// sweeps, and the points of a sweep lie in one upright plane through the scanner. So in plan the lines through points
/// that follow one another meet there; its height is the one from which the sweep's steps are even.
///
/// Empty unless nearly all points belong to stations that are found so: shuffled or sorted clouds, clouds of sweeps
/// along rows and those of moving scanners have none. Poses are upright, without a turn. O(n).
std::vector<Station> find_stations(const Cloud& cloud, Task& task);

/// The cloud, or where none of its points has a station, a copy with those that are found.
CloudPtr with_found_stations(const CloudPtr& cloud, Task& task);

/// Whether every point belongs to a station with a pose.
bool has_all_stations(const Cloud& cloud);

}  // namespace jalon
