// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/motion.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

Vec3 column(const Transform& t, size_t j) { return {t.m[j], t.m[4 + j], t.m[8 + j]}; }

Vec3 into_frame(const Transform& t, const Vec3& d) {
  return {dot(column(t, 0), d), dot(column(t, 1), d), dot(column(t, 2), d)};
}

// Rodrigues' formula.
Vec3 turned(const Vec3& axis, double angle, const Vec3& v) {
  if (angle == 0) return v;
  const double c = std::cos(angle), s = std::sin(angle);
  return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

// Axis and angle (0 ... pi) of the rotation whose columns are given, by the largest component of its quaternion.
double axis_and_angle(const Vec3& x, const Vec3& y, const Vec3& z, Vec3& axis) {
  const double w = 1 + x.x + y.y + z.z, a = 1 + x.x - y.y - z.z, b = 1 - x.x + y.y - z.z,
               c = 1 - x.x - y.y + z.z;
  const double most = std::max({w, a, b, c});
  double scalar;
  if (most == w) axis = {y.z - z.y, z.x - x.z, x.y - y.x}, scalar = w;
  else if (most == a) axis = {a, y.x + x.y, z.x + x.z}, scalar = y.z - z.y;
  else if (most == b) axis = {y.x + x.y, b, z.y + y.z}, scalar = z.x - x.z;
  else axis = {z.x + x.z, z.y + y.z, c}, scalar = x.y - y.x;
  if (scalar < 0) axis = -axis, scalar = -scalar;
  const double sine = norm(axis);
  axis = sine > 0 ? axis / sine : Vec3{0, 0, 1};
  return 2 * std::atan2(sine, scalar);
}

}  // namespace

Transform orthonormal(const Transform& transform) {
  const Vec3 x = normalized(column(transform, 0)), z = normalized(cross(x, column(transform, 1))),
             y = cross(z, x);
  Transform out = transform;
  for (int i = 0; i < 3; ++i) {
    double* row = out.m.data() + 4 * i;
    row[0] = x[i];
    row[1] = y[i];
    row[2] = z[i];
  }
  return out;
}

Motion::Motion(const Transform& from, const Transform& to) : from_(orthonormal(from)) {
  const Transform end = orthonormal(to);
  world_travel_ = end.translation() - from_.translation();
  travel_ = into_frame(from_, world_travel_);
  angle_ = axis_and_angle(into_frame(from_, column(end, 0)), into_frame(from_, column(end, 1)),
                          into_frame(from_, column(end, 2)), axis_);
}

Vec3 Motion::start(const Vec3& world) const {
  return into_frame(from_, world - from_.translation());
}

Vec3 Motion::seen_at(const Vec3& start, double t) const {
  return turned(axis_, -t * angle_, start - travel_ * t);
}

double Motion::acceleration_m(const Vec3& start) const {
  // q'' = Rot (angle^2 axis x (axis x (start - t travel)) + 2 angle axis x travel), and the first term is convex in t.
  const double reach = std::max(norm(cross(axis_, start)), norm(cross(axis_, start - travel_)));
  return angle_ * (angle_ * reach + 2 * norm(cross(axis_, travel_)));
}

Vec3 Motion::to_world(const Vec3& gauge, double t) const {
  return from_.direction(turned(axis_, t * angle_, gauge)) + world_travel_ * t +
         from_.translation();
}

}  // namespace jalon
