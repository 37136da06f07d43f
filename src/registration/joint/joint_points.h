// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"
#include "geometry/symmetric_eigen.h"
#include "model/trajectory/interpolation.h"
#include "registration/joint/joint_settings.h"

namespace jalon {

/// The points that are matched: where they are given, their rays, and where they stand in time.
struct JointPoints {
  std::vector<uint32_t> index;  ///< in the cloud, ascending
  std::vector<Vec3> at, origin, direction;
  std::vector<double> times_s;
  std::vector<TimePlace> places;  ///< among the control times
  std::vector<std::array<double, 3>>
      plan_covariance_m2;  ///< xx, xy, yy of the point, its pose's included
  std::vector<Vec2>
      normal;  ///< of the wall that the point looks like one of; empty where least_score is 0
  /// Where the inertial unit was at each point, and from its frame to the world; empty where attitudes stay.
  std::vector<Vec3> vehicle;
  std::vector<Matrix3> axes;
  std::vector<uint32_t> id;  ///< what the field "strip" says; empty without
  uint64_t outside = 0;      ///< points of the cloud without a place in time

  size_t size() const { return index.size(); }
  /// Of a coordinate in the plan, over all points.
  double mean_plan_variance_m2() const;
};

/// Of the points within the trajectory, one a cube of thin_m, those that look like a vertical wall.
/// Fields: "time" (float64, s), which is needed; "beam_origin" (float64 x 3) and "beam_direction" (float32 x 3), else
/// rays come from the laser at the trajectory; "covariance" (float32 x 6), else sigmas of the trajectory and of a
/// point. Error(kInvalidArgument) for a field that lacks, a time that is not finite, or where no point is within the
/// trajectory's time.
JointPoints joint_points(const Cloud& cloud, const Trajectory& trajectory,
                         std::span<const double> control_times_s, const JointSettings& settings,
                         Task& task);

}  // namespace jalon
