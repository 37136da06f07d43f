// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/trajectory.h"

#include <cmath>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

namespace {

// From north, east, down to east, north, up, and back: it is its own inverse.
constexpr Matrix3 kNorthEastDown{{0, 1, 0, 1, 0, 0, 0, 0, -1}};

constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr const char* kAngleNames[] = {"roll", "pitch", "yaw"};

void require_list(const std::vector<Vec3>& list, size_t epochs, const char* what,
                  const char* const (&names)[3], bool is_sigma) {
  if (list.empty()) return;
  if (list.size() != epochs)
    fail(Status::kInvalidArgument, "there are %zu epochs and %zu of %s", epochs, list.size(), what);
  for (size_t i = 0; i < epochs; ++i)
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(list[i][k]) || (is_sigma && !(list[i][k] > 0)))
        fail(Status::kInvalidArgument, "epoch %zu of the trajectory: %s %s is %s%s", i, what,
             names[k], text_of(list[i][k]).c_str(),
             is_sigma ? "; a standard deviation must be positive" : "");
}

}  // namespace

Matrix3 attitude_rotation(AxesConvention convention, const Vec3& roll_pitch_yaw_rad) {
  const Matrix3 turned = rotation_zyx(roll_pitch_yaw_rad);
  return convention == AxesConvention::kEnu ? turned : kNorthEastDown * turned;
}

Vec3 attitude_angles(AxesConvention convention, const Matrix3& rotation) {
  return angles_zyx(convention == AxesConvention::kEnu ? rotation : kNorthEastDown * rotation);
}

void validate(const Trajectory& trajectory) {
  const size_t n = trajectory.size();
  if (n < 2) fail(Status::kInsufficientData, "a trajectory of %zu epochs: two are needed", n);
  for (size_t i = 0; i < n; ++i) {
    const double t = trajectory.times_s[i];
    if (!std::isfinite(t))
      fail(Status::kInvalidArgument, "epoch %zu of the trajectory: time is %s", i,
           text_of(t).c_str());
    if (i > 0 && !(t > trajectory.times_s[i - 1]))
      fail(Status::kInvalidArgument,
           "epoch %zu of the trajectory: time %s is not after time %s of the epoch before", i,
           text_of(t).c_str(), text_of(trajectory.times_s[i - 1]).c_str());
  }
  if (trajectory.positions.size() != n || trajectory.attitudes_rad.size() != n)
    fail(Status::kInvalidArgument, "there are %zu times, %zu positions and %zu attitudes", n,
         trajectory.positions.size(), trajectory.attitudes_rad.size());
  require_list(trajectory.positions, n, "position", kAxisNames, false);
  require_list(trajectory.attitudes_rad, n, "attitude", kAngleNames, false);
  require_list(trajectory.velocities_m_s, n, "velocity", kAxisNames, false);
  require_list(trajectory.position_sigmas_m, n, "position sigma", kAxisNames, true);
  require_list(trajectory.velocity_sigmas_m_s, n, "velocity sigma", kAxisNames, true);
  require_list(trajectory.attitude_sigmas_rad, n, "attitude sigma", kAngleNames, true);
}

}  // namespace jalon
