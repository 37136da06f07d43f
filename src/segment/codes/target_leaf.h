// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/codes/opening_front.h"

namespace jalon {

/// An even leaf among the waves of its wall.
struct TargetLeaf {
  OpeningFront front;
  double left_m = 0, right_m = 0, low_m = 0, high_m = 0;

  bool holds(double s, double z) const {
    return s > left_m && s < right_m && z > low_m && z < high_m;
  }
};

/// Points about a door's target, x = place along its upright plane, y = distance before it, z = height: the upright
/// rectangle about the target in which most points lie at one depth and fewest before or behind it. What lies up to
/// 4 cm behind it is a pane's or a panel's, but where nothing above or below stands at the front. False where none is
/// as large as a door, where the front is not seen over its width, as at the crests of a sheet, or where it has no end
/// within the radius: then a leaf and its wall are one plane.
bool find_leaf(std::span<const Vec3> points, const Vec2& target, double radius_m, TargetLeaf& leaf);

/// How far from the front of a leaf its points lie at most: twice the noise of a scanner.
constexpr double kLeafNoise_m = 0.005;

}  // namespace jalon
