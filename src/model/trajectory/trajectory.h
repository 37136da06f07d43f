// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/shared_text.h"
#include "geometry/rotation.h"
#include "geometry/vec.h"

namespace jalon {

/// How roll, pitch and yaw make the rotation R from the vehicle's frame to the world's (east,
/// north, up).
enum class AxesConvention {
  /// Vehicle: x forward, y left, z up. R = Rz(yaw) Ry(pitch) Rx(roll): yaw anticlockwise from east.
  kEnu,
  /// Vehicle: x forward, y right, z down. R = N Rz(yaw) Ry(pitch) Rx(roll), N from north, east, down
  /// to east, north, up: yaw is the heading, clockwise from north (Applanix, SBET, aeronautics).
  kNed,
};
/// Roll, pitch and yaw to the rotation from the vehicle to the world, and back.
Matrix3 attitude_rotation(AxesConvention convention, const Vec3& roll_pitch_yaw_rad);
Vec3 attitude_angles(AxesConvention convention, const Matrix3& rotation);

/// From the vehicle's x forward, y right, z down to its x forward, y left, z up: half a turn about x.
inline constexpr Matrix3 kForwardRightDown{{1, 0, 0, 0, -1, 0, 0, 0, -1}};

/// Where a vehicle was and how it stood, epoch by epoch, with what that is worth. A value; shared as
/// shared_ptr<const Trajectory>. Times ascend. The lists from velocities on are empty where nothing
/// is known, else one an epoch.
struct Trajectory {
  AxesConvention axes = AxesConvention::kEnu;
  std::vector<double> times_s;
  std::vector<Vec3> positions;
  std::vector<Vec3> attitudes_rad;  ///< roll, pitch, yaw
  std::vector<Vec3> velocities_m_s;
  std::vector<Vec3> position_sigmas_m;
  std::vector<Vec3> velocity_sigmas_m_s;
  std::vector<Vec3> attitude_sigmas_rad;
  SharedText crs;  ///< of the positions, as Cloud::crs

  size_t size() const { return times_s.size(); }
};

using TrajectoryPtr = std::shared_ptr<const Trajectory>;

/// Error(kInvalidArgument) naming epoch and field unless there are two epochs at least, times
/// ascend, numbers are finite and standard deviations positive. O(n).
void validate(const Trajectory& trajectory);

}  // namespace jalon
