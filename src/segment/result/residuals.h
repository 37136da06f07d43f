// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/task.h"
#include "segment/segmentation.h"

namespace jalon {

/// Signed distances of points to their own planes, in bins, with the normal distribution fitted to them (Boulaassal
/// 2010, 3.4.3.6 and fig. 3.9). Noise points (NaN) are left out.
struct Residuals {
  uint64_t count = 0;
  double mean_m = 0, sigma_m = 0;            ///< sigma: unbiased, about the mean (3.17)
  double skewness = 0, excess_kurtosis = 0;  ///< 0 for a normal distribution; -1.2 is flat
  double half_range_m = 0.001;               ///< bins cover [-half_range, half_range]
  uint64_t below = 0, above = 0;             ///< outside the bins
  std::vector<uint64_t> bins;

  double bin_width_m() const { return 2 * half_range_m / static_cast<double>(bins.size()); }
  /// Points in a bin about this value if the distances were normal with this mean and sigma; 0 without spread.
  double expected(double value_m) const;
};

/// Of all segments (label 0) or of one. The range is four sigma, rounded up. Same bits for any number of threads.
Residuals bin_residuals(const Segmentation& segmentation, uint32_t label, size_t bins, Task& task);

/// One row a bin: "lower", "upper" (m), "count", "expected"; and one row: "count", "mean", "sigma", "skewness",
/// "excess_kurtosis", "below", "above".
FieldTable residual_bins_table(const Residuals& residuals);
FieldTable residual_normal_table(const Residuals& residuals);

}  // namespace jalon
