// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace jalon {

/// What a sample looks like.
struct SampleStatistics {
  uint64_t count = 0;
  double mean = 0, median = 0;
  double variance = 0, deviation = 0;  ///< divided by n - 1
  double range = 0;
  double quartile_range =
      0;  ///< third less first quartile, linear between values (Hyndman & Fan 1996, 7)
  double skewness = 0,
         kurtosis = 0;  ///< without bias for normal samples: G1, G2 (excess) (Joanes & Gill 1998)
};
/// Of finite values, one at least; NaN where a statistic needs more, or a variance that is not 0.
SampleStatistics sample_statistics(std::span<const double> values);

/// Shapiro & Wilk's test of normality (1965) with the coefficients and the p-value of Royston (1995,
/// AS R94): values from 3 to 5000.
constexpr uint64_t kLeastShapiroWilk = 3, kMostShapiroWilk = 5000;
struct ShapiroWilk {
  double W = 1, p = 1;
};
/// Error(kInsufficientData) below 3 values, kLimit above 5000, kDegenerate where all are equal.
ShapiroWilk shapiro_wilk(std::span<const double> values);
/// P(W or less) for a sample of n normal values; one_less_W is 1 - W, which keeps its digits.
double shapiro_wilk_p(double one_less_W, uint64_t n);

}  // namespace jalon
