// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/local_surface.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

// Any unit vector across n, chosen by its least coordinate.
Vec3 across(const Vec3& n) {
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  const Vec3 axis = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  return normalized(cross(n, axis));
}

// Newton's steps to the foot on a quadric: two or three do (the first is exact for a plane), one more for safety.
constexpr int kNewtonSteps = 4;

}  // namespace

void LocalSurface::set_plane(const Vec3& normal, const Vec3& centroid, double reach_m) {
  normal_ = normal;
  centroid_ = centroid;
  reach_m_ = reach_m;
}

Vec3 LocalSurface::to_frame(const Vec3& p) const {
  const Vec3 d = p - centroid_;
  return {dot(d, u_), dot(d, v_), dot(d, normal_)};
}

bool LocalSurface::set_quadric(std::span<const Vec3> points) {
  u_ = across(normal_);
  v_ = cross(normal_, u_);
  work_.clear();
  scale_ = 0;
  for (const Vec3& p : points) {
    work_.push_back(to_frame(p));
    scale_ = std::max({scale_, std::fabs(work_.back().x), std::fabs(work_.back().y)});
  }
  return fit_quadric(work_, scale_, quadric_);
}

bool LocalSurface::set_triangles(std::span<const Vec3> points) {
  u_ = across(normal_);
  v_ = cross(normal_, u_);
  return triangles_.set(points, centroid_, u_, v_);
}

bool LocalSurface::foot_on_plane(const Vec3& p, Vec3& foot) const {
  foot = p - normal_ * dot(normal_, p - centroid_);
  return within_reach(foot);
}

// Least |(x, y, q(x, y)) - p|^2. Where its second derivatives do not say down, those of the tangent plane do.
bool LocalSurface::foot_on_quadric(const Vec3& p, Vec3& foot) const {
  const Vec3 at = to_frame(p);
  const Quadric& q = quadric_;
  double x = at.x, y = at.y;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const double qx = 2 * q.a * x + q.b + q.c * y, qy = q.c * x + q.d + 2 * q.e * y;
    const double above = q.height(x, y) - at.z;
    const double gx = x - at.x + above * qx, gy = y - at.y + above * qy;
    double xx = 1 + qx * qx + above * 2 * q.a, xy = qx * qy + above * q.c,
           yy = 1 + qy * qy + above * 2 * q.e;
    if (!(xx > 0 && xx * yy - xy * xy > 0)) xx = 1 + qx * qx, xy = qx * qy, yy = 1 + qy * qy;
    const double inverse = 1 / (xx * yy - xy * xy);
    x -= (yy * gx - xy * gy) * inverse;
    y -= (xx * gy - xy * gx) * inverse;
  }
  foot = centroid_ + u_ * x + v_ * y + normal_ * q.height(x, y);
  return within_reach(foot);
}

}  // namespace jalon
