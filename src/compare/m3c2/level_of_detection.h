// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// Where a surface lies along a normal, and how well that is known.
struct SurfacePosition {
  double position_m = 0;
  double spread_m = 0;     ///< standard deviation of the points, robust for a median
  double variance_m2 = 0;  ///< of the position
  double dof = 0;          ///< degrees of freedom of that variance; infinity: it is known
};

/// Mean of n >= 2 values; variance s^2 / n with n - 1 degrees of freedom.
SurfacePosition mean_position(std::span<const double> values);

/// Variance of the median of n normal values of this variance (see MedianEstimator).
double variance_of_median(double variance, size_t n);

/// Medians and the standard error of a median from the sample itself.
///
/// Price & Bonett (2001): the distance of the order statistics c and n - c + 1, c = round((n + 1) / 2 - sqrt(n)),
/// measures the density at the median, whatever the distribution; one measured along a slope or rounded to
/// millimetres is as good as a normal one. They scale it for large n; here the scale makes its square unbiased for
/// normal samples of every n: the standard deviation of the median, sigma sqrt(pi / 2 / (n + 0.46)) for odd and
/// sqrt(pi / 2 / (n + 1.36)) for even n (within 1 % for n >= 5, by simulation), over the expected distance by Blom
/// (1958), 2 Phi^-1((n + 5/8 - c) / (n + 1/4)), with its scatter, that of about f = sqrt(n) + 2 degrees of freedom
/// (simulated: 5.9 at 10, 7.6 at 30, 11.5 at 100, 19.4 at 300): over sqrt(1 + 1 / (2 f)).
class MedianEstimator {
 public:
  MedianEstimator();
  /// Of n >= 3 ascending values. Spread: the interquartile range over that of the standard normal distribution.
  SurfacePosition operator()(std::span<const double> ascending) const;

 private:
  struct Order {
    size_t rank;    ///< c - 1
    double factor;  ///< standard error over the distance of the two values
  };
  static Order order_for(size_t n);
  std::vector<Order> table_;  ///< of the sizes that come up often
};

/// Variance of the registration along a normal at a place: J S J^T with J = [(p - centre) x n, n], S the covariance of
/// a small rotation (rad) and translation (m) about the centre, rotations first, row-major.
class RigidUncertainty {
 public:
  RigidUncertainty(std::span<const double> covariance36, const Vec3& centre);
  double variance_along(const Vec3& place, const Vec3& normal) const;

 private:
  std::array<double, 36> covariance_{};
  Vec3 centre_;
};

/// Smallest distance that is told from none with a confidence (Lague, Brodu & Leroux 2013, equation 1, with the
/// quantile that the numbers of points deserve).
class LevelOfDetection {
 public:
  explicit LevelOfDetection(double confidence);
  /// q sqrt(v1 + v2 + registration_variance_m2) + q_normal registration_error_m, q the quantile of Student's
  /// distribution at the degrees of freedom of Welch (1947) and Satterthwaite (1946).
  double level_m(const SurfacePosition& a, const SurfacePosition& b, double registration_error_m,
                 double registration_variance_m2) const;
  /// Two-sided quantile of Student's distribution, dof >= 1, within 1e-9 of itself (1e-7 below 3).
  double quantile(double dof) const;

 private:
  std::vector<double> table_;  ///< over 1 / dof
};

}  // namespace jalon
