// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/params.h"
#include "compare/m3c2/level_of_detection.h"
#include "geometry/vec.h"

namespace jalon {

/// The parameters of method "m3c2", read and checked; see m3c2_rows() for what they mean.
struct M3c2Settings {
  enum class Normals { kScale, kVertical, kHorizontal, kGiven };
  enum class Source { kReference, kCompared, kCore };
  enum class Orientation { kAutomatic, kDirection, kStation, kPoint };

  Source core_from = Source::kReference;
  double core_spacing_m = 0;
  Normals normals = Normals::kScale;
  std::vector<double> normal_radii_m;  ///< ascending, at least one
  Source normals_from = Source::kReference;
  Orientation orientation = Orientation::kAutomatic;
  Vec3 direction, viewpoint;
  double cylinder_radius_m = 0, max_depth_m = 0;
  bool median = true;
  double surface_gap_m = 0;  ///< 0: all points are one surface
  uint32_t min_points = 0;
  double confidence = 0;
  double registration_error_m = 0;
  std::optional<RigidUncertainty> registration;
  bool point_covariances = false;
};

M3c2Settings m3c2_settings(const ParamSet& params);

}  // namespace jalon
