// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "base/params.h"

namespace jalon {

/// Where the normals of the consistency test come from.
enum class NormalSource { kCells, kField, kNone };

/// The parameters of method "ransac" as plain values; names, defaults and help stand in ransac_params.cpp.
struct RansacSettings {
  double distance_tolerance_m = 0.025;  ///< half-thickness
  double min_area_m2 = 0.05;
  uint32_t min_points = 50;
  double probability = 0.99;
  uint32_t max_planes = 0;  ///< 0 = no limit
  uint64_t seed = 1;
  bool connectivity = true;
  double pixel_m = 0;  ///< 0 = 2 x spacing of the segment
  double gap_m = 0.5;
  double merge_gap_m = 0.5;
  NormalSource normals = NormalSource::kCells;
  double normal_tolerance_rad = 0.44;
  double orientation_tolerance_rad = 0.0175;
  bool facade_frame = true;

  bool uses_normals() const { return normals != NormalSource::kNone; }
};

RansacSettings ransac_settings(const ParamSet& params);

}  // namespace jalon
