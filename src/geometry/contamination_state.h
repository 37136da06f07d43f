// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "base/task.h"
#include "geometry/contaminated_plane.h"
#include "geometry/contamination.h"
#include "geometry/symmetric_eigen.h"

namespace jalon {

constexpr size_t kContaminationZones = 2;

/// The unknowns of a contaminated plane: a correction of the start plane, the noise, the shares of each zone.
struct ContaminationState {
  double height = 0, slope_u = 0, slope_v = 0;
  double sigma_m = 0;
  std::array<double, kContaminationZones> front{}, behind{};

  double residual(const PlaneSample& s) const {
    return static_cast<double>(s.d) -
           (height + slope_u * static_cast<double>(s.u) + slope_v * static_cast<double>(s.v));
  }
  std::vector<ContaminationTable> tables(
      double tolerance_m,
      ContaminationTable::With with = ContaminationTable::With::kWeightsAlone) const;
};

/// Covariance of (slope_u, slope_v, height) at the maximum of the likelihood, shares of 0 taken as known. Few points:
/// by the one-step jackknife (Hinkley 1977), which allows for their leverage; many: inverse Hessian x scores x inverse
/// Hessian (White 1982, theorem 3.2). False when the points do not determine the unknowns.
bool contamination_covariance(const std::vector<PlaneSample>& samples,
                              const ContaminationState& state, double tolerance_m, Task& task,
                              Symmetric3& out);

}  // namespace jalon
