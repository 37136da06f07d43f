// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "registration/joint/joint_points.h"

// A constant error of the attitudes: the inertial unit sits turned in the vehicle, by small angles about the vehicle's
// own axes (forward, left or right, up or down; roll, pitch, heading). The points turn about the inertial unit:
//
//   P' = T + R Exp(b) R^T (P - T),  dP' / db_k = (R e_k) x (P - T)
namespace jalon {

/// What each of three small turns about the vehicle's axes does to a point (m/rad); arm: P - T.
inline std::array<Vec3, 3> turn_derivatives(const Matrix3& axes, const Vec3& arm) {
  return {cross(axes.column(0), arm), cross(axes.column(1), arm), cross(axes.column(2), arm)};
}

/// The points, their beams and the vehicle's axes with the attitudes turned by these angles. Of points that know their
/// vehicle.
JointPoints turned(const JointPoints& given, const Vec3& bias_rad);

/// Plan derivatives of each point by the three turns.
std::vector<std::array<Vec2, 3>> plan_turns(const JointPoints& points);

/// Root mean square of the points from the inertial unit: what a turn of one radian moves, at most.
double mean_reach_m(const JointPoints& points);

/// The trajectory with its attitudes turned; 0 leaves all bits.
Trajectory turned(const Trajectory& given, const Vec3& bias_rad);

}  // namespace jalon
