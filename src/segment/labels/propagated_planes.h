// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "base/field.h"
#include "base/numbers.h"
#include "base/task.h"
#include "cloud/precision.h"
#include "segment/segmentation.h"

namespace jalon {

/// A plane adjusted with what its points are worth, and what that makes its parameters worth.
struct PropagatedPlane {
  uint32_t label = 0;
  Plane plane{{kNaN, kNaN, kNaN}, kNaN};
  std::array<double, 16> covariance =
      filled();                 ///< of (normal, offset), from the points' covariances
  double sigma_prior_m = kNaN;  ///< of the points along the normal, root of their mean variance
  double sigma_m = kNaN;        ///< of their residuals, n - 3
  double variance_factor =
      kNaN;  ///< residuals against their own sigmas, n - 3: 1 where the budget is right

  static constexpr std::array<double, 16> filled() {
    std::array<double, 16> out{};
    for (double& value : out) value = kNaN;
    return out;
  }
};

/// Weighted least squares of each planar segment, weights 1 / (n^T C_i n) from the scanner's
/// precision (Boulaassal 2010, 5.3.3; Mikhail & Gracie 1981): covariance N^-1, a priori. Errors of
/// points are independent; what all points of a station have in common (its position, back-sight,
/// level) does not average out and is left out. Other segments have NaN. O(n).
std::vector<PropagatedPlane> propagate_planes(const Segmentation& segmentation,
                                              const ScannerPrecision& precision, Task& task);
FieldTable propagated_plane_table(const std::vector<PropagatedPlane>& planes);

}  // namespace jalon
