// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/rigid_motion.h"

#include <cmath>
#include <numbers>

namespace jalon {

Transform rotation_by(const Vec3& rotation) {
  const double angle = norm(rotation);
  // sin(a) / a and (1 - cos(a)) / a^2; their series where a^2 is lost in rounding.
  const double small = angle * angle;
  const double s = small > 1e-12 ? std::sin(angle) / angle : 1 - small / 6;
  const double half = std::sin(angle / 2);
  const double c = small > 1e-12 ? 2 * half * half / small : 0.5 - small / 24;
  const Vec3& r = rotation;
  Transform out;
  out.m = {1 - c * (r.y * r.y + r.z * r.z), c * r.x * r.y - s * r.z,
           c * r.x * r.z + s * r.y,         0,
           c * r.x * r.y + s * r.z,         1 - c * (r.x * r.x + r.z * r.z),
           c * r.y * r.z - s * r.x,         0,
           c * r.x * r.z - s * r.y,         c * r.y * r.z + s * r.x,
           1 - c * (r.x * r.x + r.y * r.y), 0};
  return out;
}

Transform motion_about(const Vec3& centre, const Vec3& rotation, const Vec3& shift) {
  Transform out = rotation_by(rotation);
  const Vec3 t = centre + shift - out.direction(centre);
  out.m[3] = t.x;
  out.m[7] = t.y;
  out.m[11] = t.z;
  return out;
}

Vec3 rotation_vector(const Transform& motion) {
  const auto& m = motion.m;
  const Vec3 twice_sine{m[9] - m[6], m[2] - m[8], m[4] - m[1]};
  const double sine = norm(twice_sine) / 2, cosine = (m[0] + m[5] + m[10] - 1) / 2;
  const double angle = std::atan2(sine, cosine);
  if (sine > 1e-9) return twice_sine * (angle / (2 * sine));
  if (cosine > 0) return twice_sine * 0.5;
  // Half a turn: the axis is the largest column of (R + I) / 2 = axis axis^T.
  const Vec3 columns[3] = {{m[0] + 1, m[4], m[8]}, {m[1], m[5] + 1, m[9]}, {m[2], m[6], m[10] + 1}};
  const Vec3* largest = &columns[0];
  for (const Vec3& column : columns)
    if (squared_norm(column) > squared_norm(*largest)) largest = &column;
  return normalized(*largest) * std::numbers::pi;
}

double MotionModel::residual(const PlanePair& pair, Coefficients<6>& derivatives) const {
  const Vec3 moved = motion_.point(pair.from);
  const Vec3 lever = cross(moved - motion_.point(centre_), pair.normal);
  derivatives = {lever.x, lever.y, lever.z, pair.normal.x, pair.normal.y, pair.normal.z};
  return dot(pair.normal, moved - pair.to);
}

void MotionModel::move(const Coefficients<6>& step) {
  motion_ = motion_about(motion_.point(centre_), {step[0], step[1], step[2]},
                         {step[3], step[4], step[5]}) *
            motion_;
}

}  // namespace jalon
