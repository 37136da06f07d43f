// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/primitive_draws.h"
#include "geometry/vec.h"

namespace jalon {

/// |p - centre| = radius.
struct Sphere {
  Vec3 centre;
  double radius = 0;
  /// Signed: positive outside.
  double distance(const Vec3& p) const { return norm(p - centre) - radius; }
};

/// A sphere adjusted to points, with the covariance of its parameters.
struct SphereFit {
  Sphere sphere;
  uint64_t n = 0;    ///< points that carry it
  double sigma = 0;  ///< standard deviation of the distances, m
  std::array<double, 16>
      covariance{};  ///< of (centre x, y, z, radius), row-major; NaN for 4 points
};

/// Sphere through four points: its centre lies on the planes that halve their distances (Boulaassal 2010, E.1.1.1).
/// False when they are nearly in one plane.
bool sphere_through(const std::array<Vec3, 4>& points, Sphere& out);
/// Linear least squares of x^2 + y^2 + z^2 = A + 2 x x0 + 2 y y0 + 2 z z0 for 4 points or more, about their centroid
/// (E.1.1.2). False when they are in one plane.
bool sphere_linear(std::span<const Vec3> points, Sphere& out);
/// Centre halfway between the lines of two points along their normals, where they are closest (Schnabel et al. 2007).
/// False when the normals are nearly parallel.
bool sphere_from_normals(const Vec3& p1, const Vec3& n1, const Vec3& p2, const Vec3& n2,
                         Sphere& out);

/// Adjusts a sphere from a start, by Gauss-Newton with damping (E.1.1; segment members within the tolerance of it).
bool adjust_sphere(std::span<const Vec3> points, const Sphere& start,
                   const PrimitiveSetting& setting, Task& task, SphereFit& out);
/// From points alone: 1. start by random draws of 4 points, or linear when not robust; 2. adjustment. False when the
/// points are fewer than 4, in one plane, leave the radius open (its standard deviation above half of it), or put it
/// outside the limits.
bool fit_sphere(std::span<const Vec3> points, const PrimitiveSetting& setting, Task& task,
                SphereFit& out);

}  // namespace jalon
