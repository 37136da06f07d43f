// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "base/task.h"
#include "geometry/geodesy/map_projection.h"
#include "model/trajectory/trajectory.h"

// Files of trajectories: text with named columns, and SBET with its file of sigmas (smrmsg).
namespace jalon {

enum class TrajectoryFormat { kAuto, kText, kSbet };
/// What an SBET file's heading is measured from.
enum class SbetHeading {
  kMinusWander,  ///< true heading = heading - wander angle
  kPlusWander,   ///< true heading = heading + wander angle
  kTrue,         ///< the heading is the true one, whatever the wander angle
};

/// The settings of operation "trajectory_file".
struct TrajectoryFileSettings {
  TrajectoryFormat format = TrajectoryFormat::kAuto;
  AxesConvention axes = AxesConvention::kEnu;  ///< of text that does not say them
  MapSystem projection = MapSystem::kUtm;
  int64_t utm_zone = 0;  ///< 0: that of the first record
  bool utm_south = false;
  std::vector<double>
      origin;  ///< of kEnu: latitude, longitude (rad), height (m); empty: the first record
  SbetHeading heading = SbetHeading::kMinusWander;
  double time_shift_s = 0;
};
std::span<const ParamRow> trajectory_file_rows();

/// sigma_path: of a file smrmsg; "" without one. Errors name file, record and field.
Trajectory read_trajectory(const std::string& path, const std::string& sigma_path,
                           const TrajectoryFileSettings& settings, Task& task);
/// sigma_path: "" writes no smrmsg. An SBET file is told by the format, or by the extension "out" or
/// "sbet".
void write_trajectory(const Trajectory& trajectory, const std::string& path,
                      const std::string& sigma_path, const TrajectoryFileSettings& settings,
                      Task& task);

/// The choice of world, made whole by the first place.
MapProjection projection_of(const TrajectoryFileSettings& settings, const Geodetic& first);

}  // namespace jalon
