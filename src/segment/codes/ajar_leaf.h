// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/codes/opening_sides.h"

namespace jalon {

/// The leaf of an opening that stands open inward, turned about its left or right end.
struct AjarLeaf {
  Vec2 hinge;           ///< along the opening's plane, and before it
  Vec2 along;           ///< from the hinge to the free end, length 1
  OpeningFront front;   ///< in the leaf's own coordinates
  double length_m = 0;  ///< to where its points end
  double low_m = 0, high_m = 0;
  size_t points = 0;  ///< at its front

  /// Of its plane: to the viewer, whichever end it turns about.
  Vec2 outward() const { return along.u > 0 ? Vec2{-along.v, along.u} : Vec2{along.v, -along.u}; }
  /// p as of find_opening_front: x from the hinge along the leaf, y before it, z = height.
  Vec3 of(const Vec3& p) const;
  /// At its front or up to the distance behind it.
  bool holds(const Vec3& p, double distance_m) const;
};

/// Widest way of a leaf that is sought, relative to its length: 30 degrees.
inline constexpr double kWidestAjar = 0.5;

/// Points about an opening and behind it, its front, the place of a hinge and how far the leaf reaches from there
/// (negative: to the left): the plane through the hinge that most points lie in, as far as they follow one another.
/// False where none stands open by 3 degrees or more.
bool find_ajar_leaf(std::span<const Vec3> points, const OpeningFront& front, double hinge_m,
                    double reach_m, double low_m, double high_m, AjarLeaf& leaf);

/// The leaf about either end, where more points lie at its front than at that of the shut opening; else false.
bool find_ajar_leaf(std::span<const Vec3> points, const OpeningFront& front,
                    const OpeningEnds& ends, double reach_m, AjarLeaf& leaf);

}  // namespace jalon
