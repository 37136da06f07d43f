// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/nearest_point.h"

#include <algorithm>

namespace jalon {

namespace {

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double length2 = squared_norm(ab);
  if (!(length2 > 0)) return a;
  return a + ab * std::clamp(dot(p - a, ab) / length2, 0.0, 1.0);
}

Vec3 nearest_on_border(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  Vec3 best = nearest_on_segment(p, a, b);
  for (const Vec3& other : {nearest_on_segment(p, b, c), nearest_on_segment(p, c, a)})
    if (squared_norm(p - other) < squared_norm(p - best)) best = other;
  return best;
}

}  // namespace

Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, normal = cross(ab, ac);
  const double area2 = squared_norm(normal);
  // Signed areas of the three triangles that p's foot makes with the edges: all positive inside.
  const Vec3 ap = p - a;
  const double v = dot(cross(ap, ac), normal), w = dot(cross(ab, ap), normal);
  if (area2 > 0 && v > 0 && w > 0 && v + w < area2) return a + ab * (v / area2) + ac * (w / area2);
  return nearest_on_border(p, a, b, c);
}

}  // namespace jalon
