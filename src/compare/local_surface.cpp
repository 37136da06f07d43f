// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/local_surface.h"

#include <algorithm>
#include <cmath>

#include "spatial/triangle_closest.h"

namespace jalon {

namespace {

// Any unit vector across n, chosen by its least coordinate.
Vec3 across(const Vec3& n) {
  const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
  const Vec3 axis = x <= y && x <= z ? Vec3{1, 0, 0} : y <= z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  return normalized(cross(n, axis));
}

// Step of the triangulation's grid as a share of its size: finer than any scanner's noise.
constexpr double kGridShare = 0x1p-24;
// Newton's steps to the foot on a quadric: two or three do (the first is exact for a plane), one more for safety.
constexpr int kNewtonSteps = 4;

Vector<double> vector_of(const Vec3& p) { return {p.x, p.y, p.z}; }

// From the closest point of the triangle to p.
Vec3 rest_of(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, double& squared) {
  const auto closest = closest_on_triangle(vector_of(p), vector_of(a), vector_of(b), vector_of(c));
  squared = closest.squared;
  if (!closest.on_face) return {closest.rest.x, closest.rest.y, closest.rest.z};
  return Vec3{closest.normal.x, closest.normal.y, closest.normal.z} * (closest.height / closest.normal2);
}

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
  corners_.assign(points.begin(), points.end());
  flat_.clear();
  double size = 0;
  for (const Vec3& p : points) {
    const Vec3 d = p - centroid_;
    flat_.push_back({dot(d, u_), dot(d, v_)});
    size = std::max({size, std::fabs(flat_.back().u), std::fabs(flat_.back().v)});
  }
  triangles_ = {};
  if (size > 0) triangles_ = delaunay_.run(flat_, size * kGridShare);
  sides_.resize(triangles_.size());
  away_.resize(triangles_.size());
  for (size_t i = 0; i < triangles_.size(); ++i)
    for (size_t side = 0; side < 3; ++side) {
      const Vec2 &from = flat_[triangles_[i][side]], along = flat_[triangles_[i][side == 2 ? 0 : side + 1]] - from;
      sides_[i][side] = {from, along, 1 / dot(along, along)};
    }
  return !triangles_.empty();
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
    double xx = 1 + qx * qx + above * 2 * q.a, xy = qx * qy + above * q.c, yy = 1 + qy * qy + above * 2 * q.e;
    if (!(xx > 0 && xx * yy - xy * xy > 0)) xx = 1 + qx * qx, xy = qx * qy, yy = 1 + qy * qy;
    const double inverse = 1 / (xx * yy - xy * xy);
    x -= (yy * gx - xy * gy) * inverse;
    y -= (xx * gy - xy * gx) * inverse;
  }
  foot = centroid_ + u_ * x + v_ * y + normal_ * q.height(x, y);
  return within_reach(foot);
}

// No triangle is nearer than its projection, and that no nearer than the line of a side that the point lies beyond
// (they are anticlockwise). The one below or above the point comes first: it is mostly the nearest, and then no other
// has to be looked at.
bool LocalSurface::foot_on_triangles(const Vec3& p, double limit_m, Vec3& foot) const {
  const Vec3 in_plane = p - centroid_;
  const Vec2 at{dot(in_plane, u_), dot(in_plane, v_)};
  for (size_t i = 0; i < triangles_.size(); ++i) {
    double most = 0;
    for (const Side& side : sides_[i]) {
      const double beyond = std::min(0.0, cross(side.along, at - side.from));
      most = std::max(most, beyond * beyond * side.inverse_squared_length);
    }
    away_[i] = most;
  }
  double least = limit_m * limit_m;
  bool found = false;
  for (const bool below : {true, false})
    for (size_t i = 0; i < triangles_.size(); ++i) {
      if ((away_[i] == 0) != below || !(away_[i] < least)) continue;
      const auto& t = triangles_[i];
      double squared = 0;
      const Vec3 rest = rest_of(p, corners_[t[0]], corners_[t[1]], corners_[t[2]], squared);
      if (!(squared < least)) continue;
      least = squared;
      foot = p - rest;
      found = true;
    }
  return found;
}

}  // namespace jalon
