// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// Motion of a gauge from one pose to the next: its origin runs straight at an even speed, and it turns about one axis
/// at an even rate by the smaller angle (linear and spherical linear interpolation). Time runs from 0 to 1.
///
/// Seen from the gauge, an obstacle moves: q(t) = Rot(axis, -t angle) (start - t travel).
class Motion {
 public:
  /// T_world_gauge at both ends; rigid (see geometry/rigid_motion.h).
  Motion(const Transform& from, const Transform& to);

  /// Where a point of the world is at t = 0, in the gauge's frame.
  Vec3 start(const Vec3& world) const;
  Vec3 seen_at(const Vec3& start, double t) const;
  /// A bound of the acceleration of such a point: over a time h it leaves its chord by at most h^2 / 8 of it.
  double acceleration_m(const Vec3& start) const;
  /// A point of the gauge's frame at time t, in the world.
  Vec3 to_world(const Vec3& gauge, double t) const;
  /// Length of the part of a vector across the axis: accelerations have no other.
  double across_axis(const Vec3& v) const { return norm(cross(axis_, v)); }

 private:
  Transform from_;                     ///< T_world_gauge at t = 0, orthonormal
  Vec3 world_travel_, travel_, axis_;  ///< the last two in the gauge's frame
  double angle_ = 0;
};

/// The nearest rigid motion to a nearly rigid one: the rotation by Gram and Schmidt.
Transform orthonormal(const Transform& transform);

}  // namespace jalon
