// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "cloud/cloud.h"

namespace jalon {

/// The field "covariance" of a cloud (float32 or float64; 6 numbers a point: xx, xy, xz, yy, yz, zz, or 9 row-major;
/// m2), as jalon_cloud_compute_covariances makes it.
class PointCovariances {
 public:
  PointCovariances() = default;
  /// name: which cloud, for the messages. Error(kNotFound) without the field, kInvalidArgument where it has another
  /// shape.
  PointCovariances(const Cloud& cloud, const char* name);
  /// n^T C n of a point, in the caller's order; n unit.
  double variance_along(size_t point, const Vec3& normal) const;

 private:
  ColumnPtr column_;
  const float* floats_ = nullptr;
  const double* doubles_ = nullptr;
  size_t components_ = 0;
};

/// Variance of the mean or the median of values with known variances of their own, added one after the other.
///
/// Mean: sum v_i / n^2. Median: that of values with one common sigma (as in MedianEstimator), the one with which as
/// many values lie within the same 95 % range: d solves sum (Phi(d / sigma_i) - 1/2) = 1.96 sqrt(n) / 2, the scatter of
/// the rank of the median; sigma = d / Phi^-1(1/2 + 0.98 / sqrt(n)).
class PropagatedVariance {
 public:
  void clear() { variances_.clear(); }
  void add(double variance_m2) { variances_.push_back(variance_m2); }
  double of_mean() const;
  double of_median() const;

 private:
  std::vector<double> variances_;
};

}  // namespace jalon
