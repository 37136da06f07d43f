// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/contour/contour.h"

namespace jalon {

/// How a segment becomes a 2D vector model (Boulaassal 2010, 4.2-4.3): parameters of all modelling
/// methods, bound to their rows in vectorise_rows.h.
struct VectoriseSetting {
  ContourSetting contour;
  bool straighten = true;
  bool arcs = true;
  double direction_angle_rad = 0.035;
  double snap_angle_rad = 0.05;  ///< 0 = never
  double reveal_depth_m = 0.3;   ///< 0 = edges from the points of the plane alone
  double tolerance_m =
      0;  ///< half-width of a straight strip; 0 = from the widest gap of the contour
  bool rectangles = true;
};

}  // namespace jalon
