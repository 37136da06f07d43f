// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/params.h"
#include "registration/icp/pairs.h"
#include "registration/icp/robust_kernel.h"

namespace jalon {

/// The parameters of method "icp".
struct IcpSettings {
  IcpMetric metric = IcpMetric::kPointToPlane;
  KernelKind kernel = KernelKind::kTukey;
  double max_distance_m = 0;  ///< 0: from the misfit at the start
  double min_distance_m = 0;  ///< 0: by the noise
  double trim = 0;            ///< share of the pairs, the worst, without a say
  double least_cosine = 0;
  double least_overlap = 0;
  uint32_t neighbours = 0;
  int max_iterations = 0;
  bool coarse_to_fine = true;
  double cell_m = 0;          ///< 0: only where the points lie in lines
  /// Normals of a search for neighbours: those of points alone do not matter.
  double search_cosine() const { return metric == IcpMetric::kPointToPoint ? 0 : least_cosine; }
};
IcpSettings icp_settings(const ParamSet& params);

}  // namespace jalon
