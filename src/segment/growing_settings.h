// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/surface_settings.h"

namespace jalon {

enum class GrowingNormals { kNeighbours, kField };

/// The parameters of method "region_growing"; the rows stand in region_growing_params.cpp.
struct GrowingSettings {
  /// What the steps after the growing read, all of it named here. The table has those of a user's
  /// concern; the others are fixed: surfaces are planes, each of them connected, and shared out
  /// anew.
  SurfaceSettings surface{
      .distance_tolerance_m = 0.025,
      .min_area_m2 = 0.05,
      .min_points = 50,
      .connectivity = true,
      .pixel_m = 0,
      .gap_m = 0.5,  // parts of a surface no farther apart stay one, as in "ransac"
      .strip_width_m = 0,
      .merge_gap_m = 0.5,
      .normals = NormalSource::kCells,  // there are normals; which ones, the row "normals" says
      .normal_tolerance_rad = 0.349066,
      .least_radius_m = 1,
      .primitives = Primitives::kPlanes,
      .min_radius_m = 0,  // of spheres and cylinders: none
      .max_radius_m = 0,
      .reassign = true,
      .orientation_tolerance_rad = 0.0174533,
      .facade_frame = true,
  };
  GrowingNormals normals = GrowingNormals::kNeighbours;
  uint32_t k = 16;   ///< neighbours of a point's normal, itself included
  double gap_m = 0;  ///< from a region to its next points; 0 = twice the local spacing

  bool field_normals() const { return normals == GrowingNormals::kField; }
};

}  // namespace jalon
