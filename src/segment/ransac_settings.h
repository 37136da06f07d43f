// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "segment/surface_settings.h"

namespace jalon {

/// Where the tolerance comes from: distance_tolerance_m, but no less than the noise needs unless it
/// was set; distance_tolerance_m as it is; sigma and a probability; or the same with a sigma
/// estimated from the cloud.
enum class ToleranceSource { kAuto, kHand, kSigma, kEstimate };
struct ToleranceSettings {
  ToleranceSource tolerance_from = ToleranceSource::kAuto;
  double sigma_m = 0.005;
  double tolerance_probability = 0.99;
  int tolerance_dof = 1;
};

/// The three points of a draw: of one cell, or any.
enum class Sampling { kLocal, kGlobal };
/// What makes a plane the best: most points, or the least spread among those with nearly as many.
enum class Criterion { kCardinality, kStandardDeviation };
/// How surfaces are drawn, one after the other.
struct DrawSettings {
  double probability = 0.99;
  Sampling sampling = Sampling::kLocal;
  bool refit =
      true;  ///< least squares while a plane is settled; else it keeps the points of the draw
  uint64_t draws = 0;  ///< for each plane; 0 = as many as the probability needs
  Criterion criterion = Criterion::kCardinality;
  uint32_t max_planes = 0;  ///< 0 = no limit
  uint64_t seed = 1;
  std::string orientation_order;  ///< empty: all orientations together
};

/// The parameters of method "ransac"; the rows stand in ransac_params.cpp.
struct RansacSettings {
  SurfaceSettings surface;
  ToleranceSettings tolerance;
  DrawSettings draw;
};

}  // namespace jalon
