// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "cloud/cloud.h"

namespace jalon {

/// The piece of the sampled surface that a point stands for: as an area a disc of radius sqrt(A / (N pi)) (eq. 2.6).
struct PointDisc {
  float radius_m = 0;
  std::array<float, 3> across{};  ///< unit normal, of either side; 0 where no plane is told

  double area_m2() const { return std::numbers::pi * double{radius_m} * double{radius_m}; }
  Vec3 normal() const { return {double{across[0]}, double{across[1]}, double{across[2]}}; }
};

/// Discs of these points from their neighbours in the whole cloud: among the points of a region alone they would be too
/// large at the region's border. All 0 in a cloud of one point. O(m log n) for m rows.
std::vector<PointDisc> point_discs(const Cloud& cloud, std::span<const uint64_t> rows, Task& task);

/// Of the radii; 0 without any.
double radius_quantile(const std::vector<PointDisc>& discs, double share);
/// Distance up to which neighbours hang together on one surface: the edge of the cells whose
/// components are the regions (Girardeau-Montaut 2006, 3.2.4).
double joining_distance(const std::vector<PointDisc>& discs);

}  // namespace jalon
