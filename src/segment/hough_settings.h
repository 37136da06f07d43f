// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/segmentation.h"
#include "segment/surface_settings.h"

namespace jalon {

/// Which planes a point votes for: those near its normal's direction, or all that go through it.
enum class HoughVotes { kNormals, kAll };

/// The parameters of method "hough"; the rows stand in hough.cpp.
struct HoughSettings {
  SurfaceSettings surface;
  double angle_step_rad = 0.0436332;  ///< of theta and phi
  double distance_step_m = 0;         ///< of rho; 0 = two tolerances
  HoughVotes votes = HoughVotes::kNormals;
  uint32_t voters = 100000;  ///< points that vote in a round
};

/// Parameter table of method "hough".
std::span<const ParamRow> hough_rows();
/// Planes as peaks of an accumulator (see hough.cpp for the steps).
Segmentation segment_hough(const CloudPtr& cloud, const HoughSettings& settings, Task& task);

}  // namespace jalon
