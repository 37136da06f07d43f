// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>

#include "base/task.h"
#include "registration/network/network_equations.h"

namespace jalon {

struct AdjustedPoint {
  Vec3 position;
  std::array<double, 9> covariance_m2{};  ///< row-major; 0 of what is fixed
};

/// An observation after the adjustment; angles in radians, all others in metres.
struct AdjustedObservation {
  double measured = 0, residual = 0;  ///< adjusted is measured + residual
  double sigma = 0;                   ///< of what was measured, centring of the target included
  double redundancy = 0;              ///< share of an error that shows in the residual
  double normalised = 0;              ///< Baarda's w, or Pope's tau; 0 where nothing controls
  double p_value = 1;
  double detectable = INFINITY;  ///< least error that the test finds with the power
  bool is_outlier = false;
};

struct NetworkAdjustment {
  Survey survey;
  std::vector<NetworkObservation> kinds;  ///< what each observation is of
  std::vector<AdjustedPoint> points;
  std::vector<AdjustedObservation> observations;
  std::vector<double> steps_m;  ///< of the last adjustment: the greatest change of a coordinate
  bool is_converged = false;
  int unknowns = 0, defect = 0, redundancy = 0;
  size_t rejected = 0;
  double weighted_squares = 0, sigma0 = 1, p_value = 1;
};

/// Adjusts a total-station network in three dimensions by least squares (Gauss-Markov; Niemeier 2008, 5):
/// 1. approximate coordinates (approximate.h); 2. normal equations, until the coordinates stay; 3. covariances of
/// points and residuals; 4. the global test and one of each observation (Baarda 1968; sigma0 estimated: Pope 1976);
/// 5. where asked for, the worst outlier is left out and all begins again.
/// Errors: of place_points and of what nothing holds.
NetworkAdjustment adjust_network(Survey survey, const NetworkSettings& settings, Task& task);

}  // namespace jalon
