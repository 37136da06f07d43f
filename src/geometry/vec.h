// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace jalon {

struct Vec3 {
  double x = 0, y = 0, z = 0;

  double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  double& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  Vec3& operator+=(const Vec3& b) {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
  Vec3& operator-=(const Vec3& b) {
    x -= b.x;
    y -= b.y;
    z -= b.z;
    return *this;
  }
  Vec3& operator*=(double s) {
    x *= s;
    y *= s;
    z *= s;
    return *this;
  }
  bool operator==(const Vec3&) const = default;
};

inline Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
inline Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
inline Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
inline Vec3 operator*(Vec3 a, double s) { return a *= s; }
inline Vec3 operator*(double s, Vec3 a) { return a *= s; }
inline Vec3 operator/(const Vec3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double squared_norm(const Vec3& a) { return dot(a, a); }
inline double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }
/// The unit vector along a; zero stays zero.
inline Vec3 normalized(const Vec3& a) {
  const double n = norm(a);
  return n > 0 ? a / n : a;
}
inline bool is_finite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

struct Vec2 {
  double u = 0, v = 0;
  bool operator==(const Vec2&) const = default;
};
inline Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.u + b.u, a.v + b.v}; }
inline Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.u - b.u, a.v - b.v}; }
inline Vec2 operator*(const Vec2& a, double s) { return {a.u * s, a.v * s}; }
inline double dot(const Vec2& a, const Vec2& b) { return a.u * b.u + a.v * b.v; }
inline double cross(const Vec2& a, const Vec2& b) { return a.u * b.v - a.v * b.u; }
inline double norm(const Vec2& a) { return std::sqrt(dot(a, a)); }

/// Axis-parallel box; empty as made.
struct Box3 {
  Vec3 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec3 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
           -std::numeric_limits<double>::infinity()};

  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  void add(const Vec3& p) {
    for (int i = 0; i < 3; ++i) {
      min[i] = std::min(min[i], p[i]);
      max[i] = std::max(max[i], p[i]);
    }
  }
  Box3& operator+=(const Box3& b) {
    for (int i = 0; i < 3; ++i) {
      min[i] = std::min(min[i], b.min[i]);
      max[i] = std::max(max[i], b.max[i]);
    }
    return *this;
  }
  bool contains(const Vec3& p) const {
    return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y && p.z >= min.z &&
           p.z <= max.z;
  }
};

/// Affine map p' = A p + t, rows [A | t], row-major. T_a_b maps coordinates in b to coordinates in a.
struct Transform {
  std::array<double, 12> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  Vec3 point(const Vec3& p) const {
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
            m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
            m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
  }
  Vec3 direction(const Vec3& d) const {
    return {m[0] * d.x + m[1] * d.y + m[2] * d.z, m[4] * d.x + m[5] * d.y + m[6] * d.z,
            m[8] * d.x + m[9] * d.y + m[10] * d.z};
  }
  Vec3 translation() const { return {m[3], m[7], m[11]}; }
  double determinant() const {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
           m[2] * (m[4] * m[9] - m[5] * m[8]);
  }
};

/// (a * b)(p) = a(b(p)).
inline Transform operator*(const Transform& a, const Transform& b) {
  Transform c;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 4; ++j) {
      double sum = j == 3 ? a.m[4 * i + 3] : 0;
      for (size_t k = 0; k < 3; ++k) sum += a.m[4 * i + k] * b.m[4 * k + j];
      c.m[4 * i + j] = sum;
    }
  return c;
}

/// Inverse of an invertible map (determinant not 0).
inline Transform inverse(const Transform& t) {
  const auto& m = t.m;
  const double d = 1 / t.determinant();
  Transform r;
  r.m = {(m[5] * m[10] - m[6] * m[9]) * d, (m[2] * m[9] - m[1] * m[10]) * d,
         (m[1] * m[6] - m[2] * m[5]) * d,  0,
         (m[6] * m[8] - m[4] * m[10]) * d, (m[0] * m[10] - m[2] * m[8]) * d,
         (m[2] * m[4] - m[0] * m[6]) * d,  0,
         (m[4] * m[9] - m[5] * m[8]) * d,  (m[1] * m[8] - m[0] * m[9]) * d,
         (m[0] * m[5] - m[1] * m[4]) * d,  0};
  const Vec3 p = r.direction(t.translation());
  r.m[3] = -p.x;
  r.m[7] = -p.y;
  r.m[11] = -p.z;
  return r;
}

}  // namespace jalon
