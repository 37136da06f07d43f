// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/rough_angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jalon {

// By the octant: arctan on 0 ... 1 as a polynomial (Abramowitz & Stegun 1964, 4.4.49).
double rough_angle(double y, double x) {
  const double across = std::fabs(x), up = std::fabs(y);
  const double long_side = std::max(across, up);
  if (!(long_side > 0)) return std::atan2(y, x);
  const double t = std::min(across, up) / long_side, q = t * t;
  double angle =
      t * (0.9998660 + q * (-0.3302995 + q * (0.1801410 + q * (-0.0851330 + q * 0.0208351))));
  if (up > across) angle = std::numbers::pi / 2 - angle;
  if (x < 0) angle = std::numbers::pi - angle;
  return std::copysign(angle, y);
}

}  // namespace jalon
