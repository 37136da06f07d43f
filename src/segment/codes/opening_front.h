// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>

#include "geometry/vec.h"

namespace jalon {

/// The front of a frame or leaf in plan: how far it stands before a given upright plane, along that plane.
struct OpeningFront {
  double at_m = 0;    ///< where s = 0
  double slope = 0;   ///< per metre of s
  double pane_m = 0;  ///< how far behind it lies what else stands out: a pane, a panel
  double before(double s) const { return at_m + slope * s; }
};

/// Points about an opening, x = place along its plane, y = distance before it, z = height: the outermost two layers of
/// 5 mm that stand out, up to 8 cm before those with most points, else those, where no place of 5 cm counts for more
/// than most do, then the line of least squares through what lies within 1 cm of it, and at last within 5 mm. False
/// where the strongest covers fewer than 20 places.
bool find_opening_front(std::span<const Vec3> points, OpeningFront& front);

/// How far before its front a point of a frame may lie: three times the noise of a scanner. What lies farther before it
/// is the reveal of the wall.
constexpr double kBeforeFront_m = 0.008;

/// How far behind its front points of a frame or leaf may lie: as far as its text says, and its pane.
inline double depth_behind(const OpeningFront& front, double distance_m) {
  return std::max(distance_m, front.pane_m + kBeforeFront_m);
}

}  // namespace jalon
