// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/changes/region_settings.h"
#include "compare/comparison.h"
#include "geometry/plane.h"

namespace jalon {

/// Connected changed points: an object, a part of one, or several that touch (Girardeau-Montaut 2006, 3.2.4).
struct ChangeRegion {
  uint32_t label = 0;             ///< 1 = most points
  std::vector<uint32_t> indices;  ///< its points, ascending
  double area_m2 = 0;             ///< of the surface that the points sample
  double volume_m3 = 0;           ///< between that surface and the other epoch
  double mean_m = 0, rms_m = 0;   ///< distances
  double extreme_m = 0;           ///< the distance of largest size, with its sign
  Box3 box;
  Vec3 centroid;
  Eigen3 axes;  ///< of the points' covariance about the centroid
  /// Of a zone of method "landslide" alone; see ZoneMeasure.
  struct Zone {
    double volume_sigma_m3 = 0, boundary_m = 0, open_boundary_m = 0;
  } zone;
};

struct ChangeRegions {
  std::vector<uint8_t> changed;       ///< one a point of the comparison
  std::vector<uint32_t> labels;       ///< the same: 0 = in no region
  std::vector<ChangeRegion> regions;  ///< labels 1, 2 ...
  double cell_m = 0;                  ///< edge of the grid that connected them
  bool has_zones = false;             ///< they are the zones of method "landslide"
  double spacing_m = 0;               ///< sqrt(A / (N pi)) of the changed points (eq. 2.6), median
};

/// 1. Which points are changed; 2. their connected components on a grid (Girardeau-Montaut 2006,
/// 3.2.4); 3. what each measures; 4. its volume.
/// reference: the cloud that the comparison was made with, where it is at hand: it tells where distances lead to.
ChangeRegions change_regions(const Comparison& comparison, const RegionSettings& settings,
                             Task& task, const Cloud* reference = nullptr);

/// Columns "changed" (uint8) and "region" (uint32) of the comparison's points.
FieldTable region_points_table(const ChangeRegions& regions);
/// One row a region.
FieldTable regions_table(const ChangeRegions& regions);

}  // namespace jalon
