// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "registration/solvers/joint_problem.h"

namespace jalon {

/// The correlation of two strips of a facade at these places along it, where strips hang together.
double strip_correlation(const JointProblem& problem, const StripCondition& a,
                         const StripCondition& b);

/// The strips of a facade: V = D + sigma_f^2 1 1^T, D the covariance of the strips' offsets, S, and the variances of
/// what was measured. Where strips do not hang together D is diagonal, and
/// V^-1 y = y / D - (1 / D) weight sum(y / D) (Sherman & Morrison 1950); else V is inverted, O(strips^3) a facade.
struct FacadeStrips {
  std::vector<uint32_t> strips;
  std::vector<double> inverse_d;   ///< where D is diagonal
  double weight = 0;               ///< sigma_f^2 / (1 + sigma_f^2 sum(1 / D))
  double sum = 0;                  ///< sum(1 / D)
  Eigen::MatrixXd inverse, prior;  ///< V^-1 and S where strips hang together; else empty

  bool is_correlated() const { return inverse.size() > 0; }
  std::vector<double> weighted(const std::vector<double>& y) const;
};
std::vector<FacadeStrips> strips_by_facade(const JointProblem& problem);

}  // namespace jalon
