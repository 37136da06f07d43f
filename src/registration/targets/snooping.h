// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/cholesky.h"
#include "registration/targets/adjustment.h"
#include "registration/targets/settings.h"

namespace jalon {

/// The test of one target as a whole: is its place wrong by any vector? (Baarda 1968 for one dimension, Teunissen 2006,
/// chapter 4, for more.)
struct TargetTest {
  double statistic = 0;  ///< e^T P (P Q_e P)^+ P e, for sigma0 = 1
  int dimensions = 0;    ///< directions in which the other targets control this one: 0 ... 3
  double p_value = 1;    ///< of a statistic as large by chance; 1 where nothing controls the target
  std::array<double, 3>
      normalised{};  ///< Baarda's w along x, y, z; over sigma0; 0 where nothing controls
  std::array<double, 3>
      redundancy{};  ///< diagonal of Q_e P: 0 uncontrolled ... 1; they sum up to the redundancy
  std::array<double, 3>
      detectable_m{};    ///< smallest blunder along x, y, z found with the power; infinity: none
  bool outlier = false;  ///< p_value < significance
};

/// Tests one target of an adjustment; sigma0: what multiplies standard deviations (1 or estimated).
class Snooping {
 public:
  Snooping(const SnoopingSettings& setting, double weighted_squares, int redundancy);

  /// Factor of standard deviations: 1, or sqrt(e^T P e / redundancy).
  double sigma0() const { return sigma0_; }
  TargetTest test(const PairResidual& pair) const;
  /// Of a target that took no part: its distance from where the pose puts it, with the covariance of that.
  TargetTest test_prediction(const Vec3& residual_m, const Square<3>& cofactor) const;
  /// Noncentrality that a blunder in so many dimensions needs to be found with the power; infinity: never found.
  double noncentrality(int dimensions) const;
  /// Chance of a statistic of so many dimensions, for sigma0 = 1, as large or larger.
  double p_value(double statistic, int dimensions) const;
  /// The same of what took no part, off by this statistic from what the others foretell.
  double prediction_p_value(double statistic, int dimensions) const;
  double significance() const { return setting_.significance; }
  /// noncentrality(), kept.
  double needed(int dimensions) const { return needed_[static_cast<size_t>(dimensions)]; }

 private:
  double tail(double critical, int dimensions, int more) const;
  double critical(int dimensions) const;
  SnoopingSettings setting_;
  double weighted_squares_;
  int redundancy_;
  double sigma0_ = 1;
  std::array<double, 4> needed_{};  ///< noncentrality by dimensions
};

/// Chance of e^T P e as large or larger with sigma0 = 1, and as small or smaller: the global test's both sides.
double variance_factor_p_value(double weighted_squares, int redundancy);

}  // namespace jalon
