// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "modelling/contour/contour.h"

namespace jalon {

/// How contour points are told apart into straight and curved parts.
enum class LineMethod : uint8_t {
  kBestCuts,  ///< the cuts that explain the chain best (chain_parts.h)
  kRansac     ///< lines one after the other (ransac_parts.h)
};

/// How a segment becomes a 2D vector model (Boulaassal 2010, 4.2-4.3): parameters of all modelling
/// methods, bound to their rows in vectorise_rows.h.
struct VectoriseSetting {
  ContourSetting contour;
  bool straighten = true;
  bool arcs = true;
  LineMethod lines = LineMethod::kBestCuts;
  double line_tolerance_m = 0;   ///< kRansac: half-width of a line; 0 = half the spacing
  double line_gap_m = 0;         ///< kRansac: of one straight part; 0 = 5 spacings
  uint32_t line_min_points = 5;  ///< kRansac: of a straight part
  uint64_t line_seed = 1;        ///< kRansac
  double direction_angle_rad = 0.035;
  double snap_angle_rad = 0.05;  ///< 0 = never
  double reveal_depth_m = 0.3;   ///< 0 = edges from the points of the plane alone
  double tolerance_m =
      0;  ///< half-width of a straight strip; 0 = from the widest gap of the contour
  bool rectangles = true;
};

}  // namespace jalon
