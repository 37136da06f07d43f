// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/rigid_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr double kRigid = 1e-6;  // what poses in text files with seven digits keep

bool holds_finite_numbers(const Transform& t) {
  return std::all_of(t.m.begin(), t.m.end(), [](double v) { return std::isfinite(v); });
}

Vec3 column(const Transform& t, size_t j) { return {t.m[j], t.m[4 + j], t.m[8 + j]}; }

}  // namespace

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

bool is_rigid(const Transform& transform) {
  const Vec3 x = column(transform, 0), y = column(transform, 1), z = column(transform, 2);
  const double off = std::max({std::abs(dot(x, y)), std::abs(dot(y, z)), std::abs(dot(z, x)),
                               std::abs(squared_norm(x) - 1), std::abs(squared_norm(y) - 1),
                               std::abs(squared_norm(z) - 1)});
  return off <= kRigid && holds_finite_numbers(transform) && transform.determinant() > 0;
}

void require_rigid(const Transform& transform, const char* name) {
  if (is_rigid(transform)) return;
  if (!holds_finite_numbers(transform))
    fail(Status::kInvalidArgument, "%s is no rigid motion: it holds a value that is not finite",
         name);
  Transform mirrored = transform;
  for (size_t i = 2; i < 12; i += 4) mirrored.m[i] = -mirrored.m[i];
  if (is_rigid(mirrored))
    fail(Status::kInvalidArgument, "%s is no rigid motion: it mirrors (determinant -1)", name);
  fail(Status::kInvalidArgument,
       "%s is no rigid motion: the columns of its 3 x 3 part have the lengths %s, %s and %s, and "
       "must "
       "have 1 and be square to one another within 1e-6",
       name, text_of(norm(column(transform, 0)), 6).c_str(),
       text_of(norm(column(transform, 1)), 6).c_str(),
       text_of(norm(column(transform, 2)), 6).c_str());
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
