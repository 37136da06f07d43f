// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"
#include "solid/convex_hull.h"

namespace jalon {

/// Signed distance of a point from a convex body, negative inside, with a subgradient: a unit vector g such that
/// distance(x) >= value + g . (x - p) for every x. Where the distance is smooth, g points straight away from the body.
struct SignedDistance {
  double value = 0;
  Vec3 gradient;
};

/// A solid convex body in the frame of its gauge. Signed distances are exact, convex and change by at most 1 m a metre:
/// everything that this room proves rests on these three facts. Immutable.
class ConvexPiece {
 public:
  enum class Kind { kBox, kSphere, kCylinder, kHull };

  /// T_gauge_piece: a rigid motion; the box is centred on its origin. Edge lengths above 0.
  static ConvexPiece box(const Transform& frame, const Vec3& size_m);
  static ConvexPiece sphere(const Vec3& centre, double radius_m);
  /// Solid cylinder centred on the frame's origin, its axis along the frame's z.
  static ConvexPiece cylinder(const Transform& frame, double radius_m, double height_m);
  /// Throws kInsufficientData below 4 points, kDegenerate when they are flat.
  static ConvexPiece hull(std::span<const Vec3> points);

  SignedDistance distance(const Vec3& p) const;
  Kind kind() const { return kind_; }
  /// A ball around the piece.
  const Vec3& centre() const { return centre_; }
  double radius_m() const { return radius_; }

 private:
  SignedDistance local_distance(const Vec3& p) const;

  Kind kind_ = Kind::kSphere;
  Transform frame_;  ///< T_gauge_piece
  Vec3 half_;        ///< box: half edges; cylinder: radius, -, half height; sphere: radius
  ConvexHull hull_;
  Vec3 centre_;
  double radius_ = 0;
};

}  // namespace jalon
