// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/rotation.h"

namespace jalon {

Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
  Matrix3 c;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j)
      c.m[3 * i + j] =
          a.m[3 * i] * b.m[j] + a.m[3 * i + 1] * b.m[3 + j] + a.m[3 * i + 2] * b.m[6 + j];
  return c;
}

Matrix3 transposed(const Matrix3& a) {
  return {{a.m[0], a.m[3], a.m[6], a.m[1], a.m[4], a.m[7], a.m[2], a.m[5], a.m[8]}};
}

Matrix3 rotation_x(double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {{1, 0, 0, 0, c, -s, 0, s, c}};
}

Matrix3 rotation_y(double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {{c, 0, s, 0, 1, 0, -s, 0, c}};
}

Matrix3 rotation_z(double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {{c, -s, 0, s, c, 0, 0, 0, 1}};
}

Matrix3 rotation_zyx(const Vec3& angles_rad) {
  return rotation_z(angles_rad.z) * rotation_y(angles_rad.y) * rotation_x(angles_rad.x);
}

Vec3 angles_zyx(const Matrix3& rotation) {
  const auto& m = rotation.m;
  const double upright = std::hypot(m[0], m[3]);  // cosine of the pitch
  const double pitch = std::atan2(-m[6], upright);
  constexpr double kUpright = 1e-12;  // below, roll and yaw turn about the same axis
  if (upright < kUpright) return {0, pitch, std::atan2(-m[1], m[4])};
  return {std::atan2(m[7], m[8]), pitch, std::atan2(m[3], m[0])};
}

Quaternion quaternion_of(const Matrix3& rotation) {
  // From the largest of the four components, so that nothing is divided by a small number (Shepperd
  // 1978).
  const auto& m = rotation.m;
  const double trace = m[0] + m[4] + m[8];
  const double size[4] = {trace, m[0], m[4], m[8]};
  size_t most = 0;
  for (size_t i = 1; i < 4; ++i)
    if (size[i] > size[most]) most = i;
  const double twice = std::sqrt(std::max(0.0, 1 + 2 * size[most] - trace));
  const double large = twice / 2, part = 0.5 / twice;
  if (most == 0) return {large, (m[7] - m[5]) * part, (m[2] - m[6]) * part, (m[3] - m[1]) * part};
  if (most == 1) return {(m[7] - m[5]) * part, large, (m[1] + m[3]) * part, (m[2] + m[6]) * part};
  if (most == 2) return {(m[2] - m[6]) * part, (m[1] + m[3]) * part, large, (m[5] + m[7]) * part};
  return {(m[3] - m[1]) * part, (m[2] + m[6]) * part, (m[5] + m[7]) * part, large};
}

Matrix3 matrix_of(const Quaternion& q) {
  const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{1 - 2 * (yy + zz), 2 * (xy - wz), 2 * (xz + wy), 2 * (xy + wz), 1 - 2 * (xx + zz),
           2 * (yz - wx), 2 * (xz - wy), 2 * (yz + wx), 1 - 2 * (xx + yy)}};
}

}  // namespace jalon
