// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/primitive_draws.h"
#include "geometry/vec.h"

namespace jalon {

/// All points at the distance radius from an axis; direction is a unit vector.
struct Cylinder {
  Vec3 point;  ///< of the axis
  Vec3 direction{0, 0, 1};
  double radius = 0;
  double axis_distance(const Vec3& p) const { return norm(cross(p - point, direction)); }
  /// Signed: positive outside.
  double distance(const Vec3& p) const { return axis_distance(p) - radius; }
};

/// A cylinder adjusted to points, with the covariance of its parameters. The point of the axis is
/// the one at mid height;
/// the direction points upward.
struct CylinderFit {
  Cylinder cylinder;
  double length_m = 0;  ///< extent of the points along the axis
  uint64_t n = 0;       ///< points that carry it
  double sigma = 0;     ///< standard deviation of the distances, m
  /// Of (point x, y, z, direction x, y, z, radius), row-major, rank 5; 3 where the direction was given.
  std::array<double, 49> covariance{};
};

/// Two unit vectors that with the direction make a right-handed frame; they depend on the direction alone.
std::array<Vec3, 2> across(const Vec3& direction);

/// From two points with normals (Boulaassal 2010, E.26-E.31; Schnabel et al. 2007): the axis along n1 x n2, through the
/// crossing of the two normals seen along it. False when the normals are nearly parallel.
bool cylinder_from_normals(const Vec3& p1, const Vec3& n1, const Vec3& p2, const Vec3& n2,
                           Cylinder& out);
/// Of a given direction through three points or more, at any height (E.1.2). False when they are on one line as seen
/// along it.
bool cylinder_along(const Vec3& direction, std::span<const Vec3> points, Cylinder& out);
/// Direction of the largest extent (E.33-E.34). False when it cannot be the axis: a closed cylinder
/// is longest along its
/// axis from a height of 1.22 diameters on, one seen from one side earlier.
bool axis_from_covariance(std::span<const Vec3> points, Vec3& direction);

/// Adjusts all five unknowns from a start by Gauss-Newton with damping.
bool adjust_cylinder(std::span<const Vec3> points, const Cylinder& start,
                     const PrimitiveSetting& setting, Task& task, CylinderFit& out);
/// 1. start by random draws of two points with normals, or, without normals (empty), by the axis of the covariance and
/// draws of a circle across it; 2. adjustment. False when the points are fewer than 5, leave the
/// cylinder open or put its
/// radius outside the limits. Normals need no common side.
bool fit_cylinder(std::span<const Vec3> points, std::span<const Vec3> normals,
                  const PrimitiveSetting& setting, Task& task, CylinderFit& out);
/// The same with a given direction, e.g. the vertical: a circle in the projection along it; 3 points or more.
bool fit_cylinder_along(const Vec3& direction, std::span<const Vec3> points,
                        const PrimitiveSetting& setting, Task& task, CylinderFit& out);

}  // namespace jalon
