// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>

#include "base/random.h"
#include "model/trajectory/laser_beam.h"
#include "model/trajectory/trajectory.h"

namespace jalon {

/// The 18 inputs of a return in their order, and the point that they make, by the equation alone.
using LaserInputs = std::array<double, kLaserInputs>;
constexpr double kDegrees_rad = std::numbers::pi / 180;

inline LaserMount mount_of(const LaserInputs& l, BoresightOrder order) {
  return {{l[3], l[4], l[5]}, {l[6], l[7], l[8]}, order, {l[9], l[10], l[11]}};
}
inline LaserReturn return_of(const LaserInputs& l) { return {l[0], l[1], l[2]}; }
inline VehiclePose pose_of(const LaserInputs& l, AxesConvention axes) {
  return vehicle_pose(attitude_rotation(axes, {l[12], l[13], l[14]}), {l[15], l[16], l[17]},
                      axes == AxesConvention::kNed);
}
inline Vec3 point_of(const LaserInputs& l, BoresightOrder order = BoresightOrder::kZyx,
                     AxesConvention axes = AxesConvention::kEnu) {
  return BeamGeometry(mount_of(l, order)).beam(return_of(l), pose_of(l, axes)).point;
}

inline LaserInputs any_inputs(RandomStream& random) {
  const auto any = [&](double half) { return (2 * random.uniform() - 1) * half; };
  const double pi = std::numbers::pi;
  return {3 + 97 * random.uniform(),
          any(pi),
          0.1 + (pi - 0.2) * random.uniform(),
          any(0.05),
          any(0.05),
          any(0.05),
          any(0.2),
          any(0.2),
          any(pi),
          any(2),
          any(2),
          any(2),
          any(0.1),
          any(0.1),
          any(pi),
          any(1000),
          any(1000),
          any(100)};
}

/// Standard deviations of table 3.1 of Monnier (2014), with those of a good inertial unit.
inline LaserSigmas usual_sigmas() {
  const double d = kDegrees_rad;
  return {0.005, 0.001 * d, 0.001 * d, 0.001,     0.001,     0.001,    0.1 * d, 0.1 * d, 0.1 * d,
          0.001, 0.001,     0.001,     0.005 * d, 0.005 * d, 0.02 * d, 0.02,    0.02,    0.03};
}

}  // namespace jalon
