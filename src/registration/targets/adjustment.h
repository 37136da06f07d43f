// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/cholesky.h"
#include "geometry/vec.h"

namespace jalon {

/// A target measured on both sides, each with its covariance (m2).
struct TargetPair {
  Vec3 reference, moving;
  Square<3> reference_covariance{}, moving_covariance{};
};

/// What the adjustment says of one pair, in the reference's frame.
struct PairResidual {
  Vec3 residual_m;        ///< transformed moving - reference
  Square<3> weight{};     ///< P: inverse of the covariance of the residual before the adjustment (1/m2)
  Square<3> cofactor{};   ///< Q_e of the adjusted residual (m2); the redundancy matrix is Q_e P
};

struct AdjustmentStep {
  double weighted_squares = 0;  ///< e^T P e before the step
  double step = 0;              ///< of the unknowns, in their standard deviations
};

struct TargetAdjustment {
  Transform pose;
  double scale = 1;
  Vec3 centre;  ///< in the reference's frame: the unknowns are independent about it for equal weights
  /// Inverse normal matrix, for sigma0 = 1: rotation vector (rad) about the centre, shift (m) of the centre, relative
  /// change of the scale (0 for a rigid motion).
  Square<7> cofactor{};
  double weighted_squares = 0;
  int redundancy = 0;
  bool converged = false;
  std::vector<PairResidual> pairs;
  std::vector<AdjustmentStep> steps;
};

enum class AdjustmentFailure { kNone, kWeights, kLayout };

/// Weighted adjustment of a rigid or similarity motion with errors on both sides: Gauss-Helmert model, e = T(m) - r,
/// with derivatives at the adjusted places (Pope 1972; Lenzmann & Lenzmann 2004), so that the result is the
/// maximum-likelihood one. start: near the solution. kWeights: a pair (its index is written) whose two covariances add
/// up to a singular one; kLayout: the pairs do not fix the motion.
AdjustmentFailure adjust_targets(std::span<const TargetPair> pairs, bool with_scale, const Transform& start,
                                 TargetAdjustment& out, size_t& wrong_pair);

/// Covariance of T(m) - r of a pair that took no part: both its own and that of the pose (sigma0 = 1).
Square<3> predicted_cofactor(const TargetPair& pair, const TargetAdjustment& adjustment);

}  // namespace jalon
