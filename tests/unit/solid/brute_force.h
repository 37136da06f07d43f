// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Slow answers that share no code with the room under test: analytic distances of boxes, balls and cylinders, a hull as
// the intersection of half spaces, dense looks followed by a search that closes in.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "base/random.h"
#include "geometry/vec.h"

namespace brute {

using jalon::RandomStream;
using jalon::Vec3;

struct Rotation {
  std::array<std::array<double, 3>, 3> m{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3 operator()(const Vec3& v) const {
    Vec3 out;
    for (size_t i = 0; i < 3; ++i) out[int(i)] = m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z;
    return out;
  }
  Vec3 back(const Vec3& v) const {
    Vec3 out;
    for (size_t i = 0; i < 3; ++i) out[int(i)] = m[0][i] * v.x + m[1][i] * v.y + m[2][i] * v.z;
    return out;
  }
};

using Quaternion = std::array<double, 4>;  // w x y z

inline Rotation rotation_of(const Quaternion& q) {
  const auto [w, x, y, z] = q;
  return {{{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
            {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
            {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}}};
}

inline double uniform(RandomStream& random, double from, double to) {
  return from + (to - from) * random.uniform();
}
inline Vec3 any_vector(RandomStream& random, double size) {
  const double x = uniform(random, -size, size), y = uniform(random, -size, size);
  return {x, y, uniform(random, -size, size)};
}
/// A rotation by up to this angle about any axis.
inline Quaternion any_turn(RandomStream& random, double most_rad) {
  Vec3 axis;
  do axis = any_vector(random, 1);
  while (norm(axis) < 0.1 || norm(axis) > 1);
  const double half = uniform(random, 0, most_rad) / 2, s = std::sin(half) / norm(axis);
  return {std::cos(half), axis.x * s, axis.y * s, axis.z * s};
}
inline Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}
/// Spherical linear interpolation along the shorter arc.
inline Quaternion slerp(const Quaternion& a, Quaternion b, double t) {
  double c = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  if (c < 0) {
    for (double& v : b) v = -v;
    c = -c;
  }
  const double angle = std::acos(std::min(1.0, c));
  double wa = 1 - t, wb = t;
  if (angle > 1e-9)
    wa = std::sin((1 - t) * angle) / std::sin(angle), wb = std::sin(t * angle) / std::sin(angle);
  Quaternion q;
  for (size_t i = 0; i < 4; ++i) q[i] = wa * a[i] + wb * b[i];
  const double n = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& v : q) v /= n;
  return q;
}

/// Signed distance of a point in the body's own frame.
using Distance = std::function<double(const Vec3&)>;

inline Distance box(const Vec3& size) {
  return [half = size * 0.5](const Vec3& p) {
    const double x = std::fabs(p.x) - half.x, y = std::fabs(p.y) - half.y,
                 z = std::fabs(p.z) - half.z;
    return std::hypot(std::max(x, 0.0), std::max(y, 0.0), std::max(z, 0.0)) +
           std::min(std::max({x, y, z}), 0.0);
  };
}
inline Distance ball(double radius) {
  return [=](const Vec3& p) { return std::hypot(p.x, p.y, p.z) - radius; };
}
inline Distance cylinder(double radius, double height) {
  return [=](const Vec3& p) {
    const double a = std::hypot(p.x, p.y) - radius, b = std::fabs(p.z) - height / 2;
    return std::hypot(std::max(a, 0.0), std::max(b, 0.0)) + std::min(std::max(a, b), 0.0);
  };
}

/// Least value over [from, to] of a function with one valley, by golden sections.
template <class F>
double valley(const F& f, double from, double to, int steps) {
  const double g = (std::sqrt(5.0) - 1) / 2;
  double c = to - g * (to - from), d = from + g * (to - from), fc = f(c), fd = f(d),
         best = std::min(fc, fd);
  for (int i = 0; i < steps; ++i) {
    if (fc < fd) {
      to = d, d = c, fd = fc;
      c = to - g * (to - from), fc = f(c);
    } else {
      from = c, c = d, fc = fd;
      d = from + g * (to - from), fd = f(d);
    }
    best = std::min({best, fc, fd});
  }
  return best;
}

/// Least value over [0, 1] of any function: looks everywhere, then closes in on the best few.
template <class F>
double least(const F& f, int looks) {
  std::vector<std::pair<double, double>> seen;
  for (int i = 0; i <= looks; ++i) seen.emplace_back(f(double(i) / looks), double(i) / looks);
  std::sort(seen.begin(), seen.end());
  double best = seen[0].first;
  for (size_t k = 0; k < std::min<size_t>(seen.size(), 4); ++k)
    best = std::min(best, valley(f, std::max(0.0, seen[k].second - 1.0 / looks),
                                 std::min(1.0, seen[k].second + 1.0 / looks), 30));
  return best;
}

/// Least value over a triangle: a search in a search; the function must be convex.
inline double least_on_triangle(const Distance& f, const Vec3& a, const Vec3& b, const Vec3& c) {
  return valley(
      [&](double u) {
        const Vec3 p = a + (b - a) * u, q = a + (c - a) * u;
        return valley([&](double v) { return f(p + (q - p) * v); }, 0, 1, 38);
      },
      0, 1, 38);
}

}  // namespace brute
