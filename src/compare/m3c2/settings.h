// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/params.h"
#include "compare/m3c2/level_of_detection.h"
#include "geometry/vec.h"

namespace jalon {

/// The parameters of method "m3c2"; see m3c2_rows() for what they mean. Lists are as they were
/// given: check() first.
struct M3c2Settings {
  enum class Source { kReference, kCompared, kCore };
  enum class Normals { kScale, kVertical, kHorizontal, kGiven };
  enum class Orientation { kAutomatic, kDirection, kStation, kPoint };
  enum class Position { kMedian, kMean };
  enum class Surfaces { kNearest, kAll };
  enum class PrecisionFrom { kSpread, kCovariances };

  Source core_from = Source::kReference;  ///< not kCore
  double core_spacing_m = 0;              ///< 0: every point
  Normals normals = Normals::kScale;
  double normal_radius_m = 0.25;
  std::vector<double> normal_radii_m;  ///< instead of normal_radius_m
  Source normals_from = Source::kReference;
  Orientation orientation = Orientation::kAutomatic;
  std::vector<double> orientation_direction = {0, 0, 1};
  std::vector<double> viewpoint = {0, 0, 0};  ///< m
  double cylinder_radius_m = 0.15;
  double max_depth_m = 1;
  Position position = Position::kMedian;
  Surfaces surfaces = Surfaces::kNearest;
  double surface_gap_m = 0;  ///< 0: by the cylinders
  uint32_t min_points = 5;
  double confidence = 0.95;
  double registration_error_m = 0;
  std::vector<double> registration_covariance;          ///< 6 x 6 or none
  std::vector<double> registration_centre = {0, 0, 0};  ///< m
  PrecisionFrom precision_from = PrecisionFrom::kSpread;

  /// Throws kInvalidArgument where a list has not as many numbers as it needs, or the covariance
  /// is none.
  void check() const;
  std::vector<double> radii_m() const;  ///< of normals, ascending, at least one
  double gap_m() const;                 ///< between two surfaces; 0: all points are one
  std::optional<RigidUncertainty> registration() const;
};

/// Parameter table of method "m3c2".
std::span<const ParamRow> m3c2_rows();
/// Sets registration_covariance and registration_centre.
void use_registration_in_m3c2(std::span<const double> covariance36, const Vec3& centre,
                              ParamSet& params);

}  // namespace jalon
