// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/cholesky.h"
#include "geometry/vec.h"

namespace jalon {

/// Rotation about the origin by |rotation| rad about its direction (Rodrigues 1840).
Transform rotation_by(const Vec3& rotation);
/// Turns about a centre, then shifts.
Transform motion_about(const Vec3& centre, const Vec3& rotation, const Vec3& shift);
/// The rotation vector of a rigid motion, its length in [0, pi].
Vec3 rotation_vector(const Transform& motion);

/// Orthonormal within 1e-6, keeping orientation, of finite numbers.
bool is_rigid(const Transform& transform);
/// Throws kInvalidArgument unless it is; name: "pose 3" ... The message tells what is wrong with it.
void require_rigid(const Transform& transform, const char* name);

/// A point that a motion should bring onto a plane through another point (Chen & Medioni 1992).
struct PlanePair {
  Vec3 from, to, normal;
};

/// A rigid motion as the unknown of adjust(): rotation (rad) about where the centre has gone, then shift (m) of the
/// centre. The covariance of adjust() is of these six.
class MotionModel {
 public:
  using Point = PlanePair;
  static constexpr size_t kUnknowns = 6;

  MotionModel(const Transform& motion, const Vec3& centre) : motion_(motion), centre_(centre) {}
  const Transform& motion() const { return motion_; }
  double residual(const PlanePair& pair, Coefficients<6>& derivatives) const;
  void move(const Coefficients<6>& step);

 private:
  Transform motion_;
  Vec3 centre_;  ///< before the motion
};

}  // namespace jalon
