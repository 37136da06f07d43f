// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/convex_piece.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "solid/nearest_point.h"

namespace jalon {

namespace {

/// A point this near to the surface has no direction of its own left in its coordinates: the facet's normal serves.
constexpr double kOnSurface_m = 1e-12;

// Direction times a rotation's transpose.
Vec3 unrotated(const Transform& t, const Vec3& d) {
  return {t.m[0] * d.x + t.m[4] * d.y + t.m[8] * d.z, t.m[1] * d.x + t.m[5] * d.y + t.m[9] * d.z,
          t.m[2] * d.x + t.m[6] * d.y + t.m[10] * d.z};
}

SignedDistance box_distance(const Vec3& p, const Vec3& half) {
  Vec3 over;
  int most = 0;
  bool outside = false;
  for (int i = 0; i < 3; ++i) {
    over[i] = std::abs(p[i]) - half[i];
    outside = outside || over[i] > 0;
    if (over[i] > over[most]) most = i;
  }
  Vec3 gradient;
  if (!outside) {
    gradient[most] = p[most] < 0 ? -1 : 1;
    return {over[most], gradient};
  }
  for (int i = 0; i < 3; ++i) gradient[i] = over[i] > 0 ? (p[i] < 0 ? -over[i] : over[i]) : 0;
  const double value = norm(gradient);
  return {value, gradient / value};
}

SignedDistance sphere_distance(const Vec3& p, double radius) {
  const double r = norm(p);
  return {r - radius, r > 0 ? p / r : Vec3{1, 0, 0}};
}

// In the half plane (distance from the axis, height) the cylinder is a rectangle.
SignedDistance cylinder_distance(const Vec3& p, double radius, double half_height) {
  const double rho = std::sqrt(p.x * p.x + p.y * p.y);
  const Vec3 outward = rho > 0 ? Vec3{p.x / rho, p.y / rho, 0} : Vec3{1, 0, 0};
  const Vec3 along{0, 0, p.z < 0 ? -1.0 : 1.0};
  const double beside = rho - radius, beyond = std::abs(p.z) - half_height;
  if (beside <= 0 || beyond <= 0)
    return beside > beyond ? SignedDistance{beside, outward} : SignedDistance{beyond, along};
  const double value = std::sqrt(beside * beside + beyond * beyond);
  return {value, (outward * beside + along * beyond) / value};
}

SignedDistance hull_distance(const Vec3& p, const ConvexHull& hull) {
  double deepest = -std::numeric_limits<double>::infinity(),
         squared = std::numeric_limits<double>::infinity();
  Vec3 nearest, normal;
  for (const ConvexHull::Facet& facet : hull.facets) {
    const double height = dot(facet.normal, p) - facet.offset;
    if (height > deepest) {
      deepest = height;
      normal = facet.normal;
    }
    if (height <= 0 || height * height > squared) continue;
    const Vec3 candidate =
        nearest_on_triangle(p, hull.corners[facet.corners[0]], hull.corners[facet.corners[1]],
                            hull.corners[facet.corners[2]]);
    const double d = squared_norm(p - candidate);
    if (d < squared) {
      squared = d;
      nearest = candidate;
    }
  }
  if (deepest <= kOnSurface_m) return {deepest, normal};
  const double value = std::sqrt(squared);
  return {value, (p - nearest) / value};
}

}  // namespace

ConvexPiece ConvexPiece::box(const Transform& frame, const Vec3& size_m) {
  ConvexPiece piece;
  piece.kind_ = Kind::kBox;
  piece.frame_ = frame;
  piece.half_ = size_m * 0.5;
  piece.centre_ = frame.translation();
  piece.radius_ = norm(piece.half_);
  return piece;
}

ConvexPiece ConvexPiece::sphere(const Vec3& centre, double radius_m) {
  ConvexPiece piece;
  piece.kind_ = Kind::kSphere;
  piece.half_ = {radius_m, radius_m, radius_m};
  piece.centre_ = centre;
  piece.radius_ = radius_m;
  return piece;
}

ConvexPiece ConvexPiece::cylinder(const Transform& frame, double radius_m, double height_m) {
  ConvexPiece piece;
  piece.kind_ = Kind::kCylinder;
  piece.frame_ = frame;
  piece.half_ = {radius_m, radius_m, height_m / 2};
  piece.centre_ = frame.translation();
  piece.radius_ = std::sqrt(radius_m * radius_m + height_m * height_m / 4);
  return piece;
}

ConvexPiece ConvexPiece::hull(std::span<const Vec3> points) {
  ConvexPiece piece;
  piece.kind_ = Kind::kHull;
  piece.hull_ = convex_hull(points);
  Box3 box;
  for (const Vec3& p : piece.hull_.corners) box.add(p);
  piece.centre_ = (box.min + box.max) * 0.5;
  for (const Vec3& p : piece.hull_.corners)
    piece.radius_ = std::max(piece.radius_, norm(p - piece.centre_));
  return piece;
}

SignedDistance ConvexPiece::local_distance(const Vec3& p) const {
  return kind_ == Kind::kBox ? box_distance(p, half_) : cylinder_distance(p, half_.x, half_.z);
}

SignedDistance ConvexPiece::distance(const Vec3& p) const {
  if (kind_ == Kind::kSphere) return sphere_distance(p - centre_, half_.x);
  if (kind_ == Kind::kHull) return hull_distance(p, hull_);
  const SignedDistance local = local_distance(unrotated(frame_, p - centre_));
  return {local.value, frame_.direction(local.gradient)};
}

}  // namespace jalon
