// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "base/params.h"
#include "segment/orientation.h"

namespace jalon {

/// Where the normals of the consistency test come from.
enum class NormalSource { kCells, kField, kNone };
/// Where the tolerance comes from: the parameter, sigma and a probability, or a sigma estimated from the cloud.
enum class ToleranceSource { kHand, kSigma, kEstimate };
/// What makes a plane the best: most points, or the least spread among those with nearly as many.
enum class Criterion { kCardinality, kStandardDeviation };

/// The parameters of method "ransac" as plain values; names, defaults and help stand in ransac_params.cpp.
struct RansacSettings {
  ToleranceSource tolerance_from = ToleranceSource::kHand;
  double distance_tolerance_m = 0.025;  ///< half-thickness
  double sigma_m = 0.005;
  double tolerance_probability = 0.99;
  int tolerance_dof = 1;
  double min_area_m2 = 0.05;
  uint32_t min_points = 50;
  double probability = 0.99;
  bool local_sampling = true;  ///< three points of one cell; else any three
  bool refit = true;           ///< least squares while a plane is settled; else it keeps the points of the draw
  uint64_t draws = 0;       ///< for each plane; 0 = as many as the probability needs
  Criterion criterion = Criterion::kCardinality;
  uint32_t max_planes = 0;  ///< 0 = no limit
  uint64_t seed = 1;
  bool connectivity = true;
  double pixel_m = 0;  ///< 0 = 2 x spacing of the segment
  double gap_m = 0.5;
  double strip_width_m = 0;  ///< narrower parts of a surface are not its own; 0 = keep them
  double merge_gap_m = 0.5;
  NormalSource normals = NormalSource::kCells;
  double normal_tolerance_rad = 0.44;
  double least_radius_m = 1;  ///< surfaces curved more tightly are no planes; 0 = they are
  bool spheres = false, cylinders = false;  ///< looked for beside planes
  double min_radius_m = 0.03, max_radius_m = 5;  ///< of spheres and cylinders
  bool reassign = true;
  double orientation_tolerance_rad = 0.0175;
  OrientationOrder order;  ///< empty: all orientations together
  bool facade_frame = true;

  bool curved() const { return spheres || cylinders; }
  bool uses_normals() const { return normals != NormalSource::kNone; }
};

RansacSettings ransac_settings(const ParamSet& params);

}  // namespace jalon
