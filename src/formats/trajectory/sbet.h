// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "base/task.h"
#include "formats/trajectory/trajectory_files.h"
#include "model/trajectory/trajectory.h"

// Applanix's smoothed best estimate of trajectory: little-endian doubles without a header.
namespace jalon {

/// Doubles of a record of an SBET file, and of its file of sigmas (smrmsg), in their order.
enum SbetField : size_t {
  kSbetTime,       ///< s
  kSbetLatitude,   ///< rad
  kSbetLongitude,  ///< rad
  kSbetAltitude,   ///< m above the ellipsoid
  kSbetVelocityX,  ///< m/s, in the wander frame, as the next two
  kSbetVelocityY,
  kSbetVelocityZ,
  kSbetRoll,           ///< rad
  kSbetPitch,          ///< rad
  kSbetHeading,        ///< rad, from the wander frame's axis
  kSbetWanderAngle,    ///< rad
  kSbetAccelerationX,  ///< m/s2, of the vehicle, as the next two
  kSbetAccelerationY,
  kSbetAccelerationZ,
  kSbetRateX,  ///< rad/s, as the next two
  kSbetRateY,
  kSbetRateZ,
  kSbetFields,
};
enum SmrmsgField : size_t {
  kSmrmsgTime,   ///< s
  kSmrmsgNorth,  ///< m, as the next two
  kSmrmsgEast,
  kSmrmsgDown,
  kSmrmsgVelocityNorth,  ///< m/s, as the next two
  kSmrmsgVelocityEast,
  kSmrmsgVelocityDown,
  kSmrmsgRoll,  ///< minutes of arc, as the next two
  kSmrmsgPitch,
  kSmrmsgHeading,
  kSmrmsgFields,
};

/// Positions projected, attitudes of convention kNed against grid north, sigmas turned to the grid's
/// axes and interpolated to the epochs. Velocities, accelerations and rates are not taken: they
/// follow from the positions.
Trajectory read_sbet(const std::string& path, const std::string& sigma_path,
                     const TrajectoryFileSettings& settings, Task& task);
/// The other way round: the trajectory's positions are those of the settings' projection, which must
/// name zone or origin. Wander angle 0, velocities (north, east, down) from the positions where the
/// trajectory has none, accelerations and rates 0.
void write_sbet(const Trajectory& trajectory, const std::string& path,
                const std::string& sigma_path, const TrajectoryFileSettings& settings, Task& task);

}  // namespace jalon
