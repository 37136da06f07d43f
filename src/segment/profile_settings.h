// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "segment/segmentation.h"
#include "segment/surface_settings.h"

namespace jalon {

/// Along what the cloud is cut.
enum class ProfileAxes { kXyz, kZ, kDirection };

/// The parameters of method "profiles"; the rows stand in profiles.cpp.
struct ProfileSettings {
  SurfaceSettings surface;
  ProfileAxes axes = ProfileAxes::kXyz;
  std::vector<double> direction{0, 0, 1};
  double step_m = 0;            ///< between slices; 0 = five spacings, at least four tolerances
  double thickness_m = 0;       ///< of a slice; 0 = two and a half spacings
  double gap_m = 0;             ///< where a profile breaks off; 0 = four spacings
  double line_tolerance_m = 0;  ///< of Douglas-Peucker; 0 = distance_tolerance_m
  double angle_rad = 0.174533;  ///< between lines of neighbouring slices, and between rectangles
};

/// Parameter table of method "profiles".
std::span<const ParamRow> profile_rows();
/// Planes from the lines of parallel slices (see profiles.cpp for the steps).
Segmentation segment_by_profiles(const CloudPtr& cloud, const ProfileSettings& settings,
                                 Task& task);

}  // namespace jalon
