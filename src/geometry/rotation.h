// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/vec.h"

namespace jalon {

/// 3 x 3 matrix, row-major.
struct Matrix3 {
  std::array<double, 9> m{1, 0, 0, 0, 1, 0, 0, 0, 1};

  Vec3 operator*(const Vec3& v) const {
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
            m[6] * v.x + m[7] * v.y + m[8] * v.z};
  }
  Vec3 column(size_t i) const { return {m[i], m[3 + i], m[6 + i]}; }
  bool operator==(const Matrix3&) const = default;
};
Matrix3 operator*(const Matrix3& a, const Matrix3& b);
Matrix3 transposed(const Matrix3& a);

/// Right-handed rotations about the axes: Rx(angle) turns y towards z, Ry z towards x, Rz x towards y.
Matrix3 rotation_x(double angle_rad);
Matrix3 rotation_y(double angle_rad);
Matrix3 rotation_z(double angle_rad);

/// Rz(angles.z) Ry(angles.y) Rx(angles.x): roll, pitch, yaw.
Matrix3 rotation_zyx(const Vec3& angles_rad);
/// Its inverse: roll and yaw in (-pi, pi], pitch in [-pi/2, pi/2]; at a pitch of a right angle the
/// roll is 0.
Vec3 angles_zyx(const Matrix3& rotation);

/// A unit quaternion, w the real part.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
};
Quaternion quaternion_of(const Matrix3& rotation);
Matrix3 matrix_of(const Quaternion& q);

}  // namespace jalon
