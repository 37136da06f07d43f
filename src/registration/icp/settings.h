// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "registration/icp/pairs.h"
#include "registration/icp/robust_kernel.h"

namespace jalon {

/// The parameters of method "icp"; the rows stand in rows.h.
struct IcpSettings {
  IcpMetric metric = IcpMetric::kPointToPlane;
  KernelKind kernel = KernelKind::kTukey;
  double max_distance_m = 0;                    ///< 0: from the misfit at the start
  double min_distance_m = 0;                    ///< 0: by the noise
  double trim_percent = 0;                      ///< of the pairs, the worst, without a say
  double max_angle_rad = std::numbers::pi / 4;  ///< between the normals of a pair
  double min_overlap_percent = 10;
  double cell_m = 0;  ///< 0: only where the points lie in lines
  uint32_t k = 16;    ///< neighbours of a local plane
  int max_iterations = 100;
  bool coarse_to_fine = true;

  double trim() const { return trim_percent / 100; }
  double least_cosine() const { return std::cos(max_angle_rad); }
  double least_overlap() const { return min_overlap_percent / 100; }
  /// Normals of a search for neighbours: those of points alone do not matter.
  double search_cosine() const { return metric == IcpMetric::kPointToPoint ? 0 : least_cosine(); }
};

}  // namespace jalon
