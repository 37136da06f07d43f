// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/attitude_bias.h"

#include <cmath>

#include "geometry/rigid_motion.h"

namespace jalon {

JointPoints turned(const JointPoints& given, const Vec3& bias_rad) {
  JointPoints made = given;
  for (size_t i = 0; i < made.vehicle.size(); ++i) {
    const Vec3& centre = given.vehicle[i];
    const Transform turn = rotation_by(given.axes[i] * bias_rad);
    made.at[i] = centre + turn.direction(given.at[i] - centre);
    made.origin[i] = centre + turn.direction(given.origin[i] - centre);
    made.direction[i] = turn.direction(given.direction[i]);
    for (size_t k = 0; k < 3; ++k) {
      const Vec3 axis = turn.direction(given.axes[i].column(k));
      made.axes[i].m[k] = axis.x, made.axes[i].m[3 + k] = axis.y, made.axes[i].m[6 + k] = axis.z;
    }
  }
  return made;
}

std::vector<std::array<Vec2, 3>> plan_turns(const JointPoints& points) {
  std::vector<std::array<Vec2, 3>> made;
  made.reserve(points.vehicle.size());
  for (size_t i = 0; i < points.vehicle.size(); ++i) {
    const auto by = turn_derivatives(points.axes[i], points.at[i] - points.vehicle[i]);
    made.push_back({Vec2{by[0].x, by[0].y}, Vec2{by[1].x, by[1].y}, Vec2{by[2].x, by[2].y}});
  }
  return made;
}

double mean_reach_m(const JointPoints& points) {
  double squares = 0;
  for (size_t i = 0; i < points.vehicle.size(); ++i)
    squares += squared_norm(points.at[i] - points.vehicle[i]);
  return points.vehicle.empty() ? 0
                                : std::sqrt(squares / static_cast<double>(points.vehicle.size()));
}

Trajectory turned(const Trajectory& given, const Vec3& bias_rad) {
  Trajectory made = given;
  if (bias_rad == Vec3{}) return made;
  const Transform turn = rotation_by(bias_rad);
  const auto& t = turn.m;
  const Matrix3 by{{t[0], t[1], t[2], t[4], t[5], t[6], t[8], t[9], t[10]}};
  for (Vec3& attitude : made.attitudes_rad)
    attitude = attitude_angles(given.axes, attitude_rotation(given.axes, attitude) * by);
  return made;
}

}  // namespace jalon
