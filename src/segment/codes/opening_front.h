// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "geometry/vec.h"

namespace jalon {

/// The front of a frame or leaf in plan: how far it stands before a given upright plane, along that plane.
struct OpeningFront {
  double at_m = 0;   ///< where s = 0
  double slope = 0;  ///< per metre of s
  double before(double s) const { return at_m + slope * s; }
};

/// Points about an opening, x = place along its plane, y = distance before it, z = height: the two layers of 5 mm that
/// have most points, where no place of 5 cm counts for more than most do, then the line of least squares through what
/// lies within 1 cm of it, and at last within 5 mm. False where that layer covers fewer than 20 places.
bool find_opening_front(std::span<const Vec3> points, OpeningFront& front);

/// How far before its front a point of a frame may lie: three times the noise of a scanner. What lies farther before it
/// is the reveal of the wall.
constexpr double kBeforeFront_m = 0.008;

}  // namespace jalon
