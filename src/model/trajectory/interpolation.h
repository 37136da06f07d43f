// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "model/trajectory/trajectory.h"

namespace jalon {

/// Between which epochs a time lies: at share (0 ... 1) of the way from epoch to epoch + 1.
struct TimePlace {
  size_t epoch = 0;
  double share = 0;
};
/// times ascend, two at least; hint: where a time nearby was. Error(kInvalidArgument) naming item
/// and time outside of [first, last].
TimePlace time_place(std::span<const double> times_s, double time_s, size_t item, size_t hint = 0);

/// Poses between the epochs: positions on the straight line, attitudes on the shortest arc.
/// The trajectory must outlive it. Readable by many threads.
class PoseInterpolator {
 public:
  explicit PoseInterpolator(const Trajectory& trajectory);
  Vec3 position(const TimePlace& place) const {
    const Vec3& a = trajectory_.positions[place.epoch];
    return a + (trajectory_.positions[place.epoch + 1] - a) * place.share;
  }
  /// From the vehicle to the world.
  Matrix3 rotation(const TimePlace& place) const {
    const Arc& arc = arcs_[place.epoch];
    const double s = std::sin(place.share * arc.half_angle_rad),
                 c = std::cos(place.share * arc.half_angle_rad);
    const Quaternion &a = arc.start, q{c, s * arc.axis.x, s * arc.axis.y, s * arc.axis.z};
    return matrix_of({a.w * q.w - a.x * q.x - a.y * q.y - a.z * q.z,
                      a.w * q.x + a.x * q.w + a.y * q.z - a.z * q.y,
                      a.w * q.y - a.x * q.z + a.y * q.w + a.z * q.x,
                      a.w * q.z + a.x * q.y - a.y * q.x + a.z * q.w});
  }
  const Trajectory& trajectory() const { return trajectory_; }

 private:
  // From an epoch to the next: a turn about one axis of the vehicle, at an even rate.
  struct Arc {
    Quaternion start;
    Vec3 axis;  ///< unit
    double half_angle_rad = 0;
  };
  const Trajectory& trajectory_;
  std::vector<Arc> arcs_;
};

/// A value between two epochs of a list.
inline Vec3 between(const std::vector<Vec3>& list, const TimePlace& place) {
  return list[place.epoch] + (list[place.epoch + 1] - list[place.epoch]) * place.share;
}

/// The trajectory at these ascending times: sigmas and velocities linear in time. O(n + m).
Trajectory interpolated(const Trajectory& trajectory, std::span<const double> times_s);

/// Control times: every spacing_s from the first epoch on, and the last epoch. The last interval is
/// between a half and one and a half of the spacing, where the trajectory is that long.
std::vector<double> control_times(const Trajectory& trajectory, double spacing_s);

}  // namespace jalon
