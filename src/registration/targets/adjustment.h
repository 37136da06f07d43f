// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/cholesky.h"
#include "geometry/vec.h"

namespace jalon {

// Legend of registration by targets, for all files of this folder.
//
// Frames:   reference, moving: of the two sets of targets, from whole metres near each (origin_of);
//           T_reference_moving takes places of the moving frame to the reference frame, of a
//           similarity with the scale in its matrix. placed() gives it between the caller's
//           coordinates.
// r, m:     measured places of a target in either frame, with covariances C_r and C_m (m2).
// e:        misclosure T(m) - r (m), in the reference frame; P: inverse of its covariance (1/m2);
//           Q_e: covariance of the adjusted one (m2), for sigma0 = 1.
// x:        unknowns: rotation vector (rad) about the centre, shift (m) of the centre, and, of a
//           similarity, the logarithm of the scale: K = 6 or 7. A: derivatives of T(m) by x, 3 x K.
// sigma0:   what multiplies all standard deviations: 1, or estimated from the residuals.

/// A target measured on both sides, each with its covariance (m2).
struct TargetPair {
  Vec3 reference, moving;
  Square<3> reference_covariance{}, moving_covariance{};
};

/// What the adjustment says of one pair, in the reference's frame.
struct PairResidual {
  Vec3 residual_m;  ///< transformed moving - reference
  Square<3>
      weight{};  ///< P: inverse of the covariance of the residual before the adjustment (1/m2)
  Square<3> cofactor{};  ///< Q_e of the adjusted residual (m2); the redundancy matrix is Q_e P
};

struct AdjustmentStep {
  double weighted_squares = 0;  ///< e^T P e before the step
  double step = 0;              ///< of the unknowns, in their standard deviations
};

struct TargetAdjustment {
  Transform T_reference_moving;
  double scale = 1;
  Vec3
      centre;  ///< in the reference's frame: the unknowns are independent about it for equal weights
  /// Inverse normal matrix, for sigma0 = 1: rotation vector (rad) about the centre, shift (m) of the centre, relative
  /// change of the scale (0 for a rigid motion).
  Square<7> cofactor{};
  double weighted_squares = 0;
  int redundancy = 0;
  bool converged = false;
  std::vector<PairResidual> pairs;
  std::vector<AdjustmentStep> steps;
};

enum class AdjustmentFailure {
  kNone,
  kWeights,  ///< the two covariances of a pair add up to a singular one
  kLayout,   ///< the pairs do not fix the motion
};

struct AdjustedTargets {
  AdjustmentFailure failure = AdjustmentFailure::kNone;
  size_t wrong_pair = 0;        ///< of kWeights: the index of the pair
  TargetAdjustment adjustment;  ///< whole where nothing failed
};

/// Weighted adjustment of a rigid or similarity motion with errors on both sides: Gauss-Helmert
/// model, e = T(m) - r, with derivatives at the adjusted places (Pope 1972; Lenzmann & Lenzmann
/// 2004), so that the result is the maximum-likelihood one.
///
/// Before: one pair or more; T_start near the solution. After: converged says whether the steps
/// became small; pairs in the order they came; residuals and cofactors are those at the last pose.
AdjustedTargets adjust_targets(std::span<const TargetPair> pairs, bool with_scale,
                               const Transform& T_start);

/// Covariance (m2) of T(m) - r of a pair that took no part: both its own and that of the pose, for
/// sigma0 = 1.
Square<3> predicted_cofactor(const TargetPair& pair, const TargetAdjustment& adjustment);

}  // namespace jalon
