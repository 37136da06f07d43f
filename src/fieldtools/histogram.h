// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/field.h"
#include "fieldtools/noise_law.h"

namespace jalon {

/// Counts of a field's values in bins of one width; the last bin holds its upper end too.
struct Histogram {
  double from = 0, to = 0;
  std::vector<uint64_t> counts;
  std::vector<double> expected;  ///< by the law; empty without one
  uint64_t values = 0, missing = 0, below = 0, above = 0;
  double minimum = 0, maximum = 0, mean = 0, standard_deviation = 0, rms = 0, median = 0, p90 = 0,
         p95 = 0, p99 = 0;
  // Against the law, if there is one.
  double chi_square = 0, p_value = 0, kolmogorov = 0;
  uint32_t degrees_of_freedom = 0;
  double width() const { return (to - from) / static_cast<double>(counts.size()); }
};

struct HistogramSettings {
  uint64_t bins = 0;                ///< 0: the root of the number of values
  double minimum = 0, maximum = 0;  ///< equal: from the least to the largest value
  uint32_t classes = 0;  ///< of the chi-square distance; 0: the root of the number of values
};
std::span<const ParamRow> histogram_rows();
/// The counts alone, with the least and the largest value. kInsufficientData when there is no finite value.
Histogram field_counts(std::span<const double> values, const HistogramSettings& settings);
/// These and the statistics; law may be null.
Histogram field_histogram(std::span<const double> values, const NoiseLaw* law,
                          const HistogramSettings& settings, Task& task);
/// Bins "from", "to", "count" and, with a law, "expected".
FieldTable histogram_bins(const Histogram& histogram, const char* unit);
/// One row: the rest of it.
FieldTable histogram_summary(const Histogram& histogram, const char* unit);

}  // namespace jalon
