// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/table_columns.h"
#include "fieldtools/chi_square.h"
#include "fieldtools/field_values.h"

namespace jalon {

namespace {

constexpr size_t kMostAutomaticBins = 256;
constexpr size_t kCumulativeGrain = 1 << 14;  // about 1 ms

/// The value that this share of the ascending values does not exceed: between neighbours by a straight line.
double quantile_of(const std::vector<double>& sorted, double p) {
  const double at = p * static_cast<double>(sorted.size() - 1);
  const auto i = static_cast<size_t>(at);
  const size_t next = std::min(i + 1, sorted.size() - 1);
  return sorted[i] + (at - static_cast<double>(i)) * (sorted[next] - sorted[i]);
}

void set_range(const HistogramSettings& settings, Histogram& h) {
  h.from = settings.minimum;
  h.to = settings.maximum;
  if (h.to < h.from) fail(Status::kInvalidArgument, "maximum is below minimum");
  if (h.from < h.to) return;
  h.from = h.minimum;
  h.to = h.maximum;
  if (h.from < h.to) return;
  // One value only: a bin around it.
  const double half = std::max(std::fabs(h.from), 1.0) * 0x1p-20;
  h.from -= half;
  h.to += half;
}

}  // namespace

std::span<const ParamRow> histogram_rows() {
  using S = HistogramSettings;
  static constexpr auto kRows = setting_rows(
      integer_row<&S::bins>("bins", 0, 1 << 20, "", "",
                            "Number of bins; 0 = the root of the number of values, 1 to 256"),
      number_row<&S::minimum>("minimum", -1e300, 1e300, "", "",
                              "Lower end of the first bin; minimum and maximum equal = from the "
                              "least to the largest value"),
      number_row<&S::maximum>("maximum", -1e300, 1e300, "", "", "Upper end of the last bin"),
      integer_row<&S::classes>("classes", 0, 1000, "", "",
                               "Equally probable classes of the chi-square distance to the noise "
                               "law; 0 = the root of the number of values"));
  return kRows;
}

Histogram field_counts(std::span<const double> values, const HistogramSettings& settings) {
  Histogram h;
  h.minimum = std::numeric_limits<double>::infinity();
  h.maximum = -h.minimum;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    ++h.values;
    h.minimum = std::min(h.minimum, v);
    h.maximum = std::max(h.maximum, v);
  }
  if (h.values == 0) fail(Status::kInsufficientData, "the field has no finite value");
  h.missing = values.size() - h.values;
  set_range(settings, h);
  const auto root = static_cast<size_t>(std::sqrt(static_cast<double>(h.values)));
  h.counts.resize(settings.bins > 0 ? settings.bins
                                    : std::clamp<size_t>(root, 1, kMostAutomaticBins));
  const double width = h.width();
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    if (v < h.from) {
      ++h.below;
    } else if (v > h.to) {
      ++h.above;
    } else {
      ++h.counts[std::min(h.counts.size() - 1, static_cast<size_t>((v - h.from) / width))];
    }
  }
  return h;
}

Histogram field_histogram(std::span<const double> values, const NoiseLaw* law,
                          const HistogramSettings& settings, Task& task) {
  Histogram h = field_counts(values, settings);
  const std::vector<double> sorted = sorted_values(finite_values(values), task);
  const MeanAndVariance m = mean_and_variance(sorted, task);
  h.mean = m.mean;
  h.standard_deviation = std::sqrt(m.variance);
  h.rms = std::hypot(m.mean, h.standard_deviation);
  h.median = quantile_of(sorted, 0.5);
  h.p90 = quantile_of(sorted, 0.9);
  h.p95 = quantile_of(sorted, 0.95);
  h.p99 = quantile_of(sorted, 0.99);
  if (law == nullptr) return h;
  const double width = h.width();
  double before = law->cumulative(h.from);
  for (size_t b = 0; b < h.counts.size(); ++b) {
    const double after = law->cumulative(h.from + width * static_cast<double>(b + 1));
    h.expected.push_back((after - before) * static_cast<double>(h.values));
    before = after;
  }
  const ChiSquareDistance d = chi_square_distance(sorted, *law, settings.classes, task);
  h.chi_square = d.distance;
  h.degrees_of_freedom = d.classes - 1;
  h.p_value = d.p_value;
  std::vector<double> cumulative(sorted.size());
  parallel_for(task, sorted.size(), kCumulativeGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) cumulative[i] = law->cumulative(sorted[i]);
  });
  h.kolmogorov = kolmogorov_distance(cumulative);
  return h;
}

FieldTable histogram_bins(const Histogram& h, const char* unit) {
  std::vector<double> from(h.counts.size());
  for (size_t b = 0; b < from.size(); ++b) from[b] = h.from + h.width() * static_cast<double>(b);
  FieldTable t;
  add_column<double>(t, from, "from", unit, "lower end of the bin", [](double v) { return v; });
  add_column<double>(t, from, "to", unit, "upper end of the bin",
                     [&](double v) { return v + h.width(); });
  add_column<uint64_t>(t, h.counts, "count", "points", "values in the bin",
                       [](uint64_t v) { return v; });
  if (!h.expected.empty())
    add_column<double>(t, h.expected, "expected", "points", "by the noise law",
                       [](double v) { return v; });
  return t;
}

FieldTable histogram_summary(const Histogram& h, const char* unit) {
  FieldTable t;
  add_value<uint64_t>(t, "values", "points", "finite ones", h.values);
  add_value<uint64_t>(t, "missing", "points", "without a value", h.missing);
  add_value<uint64_t>(t, "below", "points", "below the first bin", h.below);
  add_value<uint64_t>(t, "above", "points", "above the last bin", h.above);
  const auto add = [&](const char* name, const char* meaning, double value) {
    add_value<double>(t, name, unit, meaning, value);
  };
  add("minimum", "least value", h.minimum);
  add("maximum", "largest value", h.maximum);
  add("mean", "of all values", h.mean);
  add("standard_deviation", "about the mean, divided by n", h.standard_deviation);
  add("rms", "about 0", h.rms);
  add("median", "half of the values are not above it", h.median);
  add("p90", "90 % are not above it", h.p90);
  add("p95", "95 % are not above it", h.p95);
  add("p99", "99 % are not above it", h.p99);
  if (h.expected.empty()) return t;
  add_value<double>(t, "chi_square", "1", "distance to the noise law", h.chi_square);
  add_value<uint32_t>(t, "degrees_of_freedom", "", "of that distance", h.degrees_of_freedom);
  add_value<double>(t, "p_value", "1",
                    "probability of such a distance, or a larger one, under the law", h.p_value);
  add_value<double>(t, "kolmogorov", "1", "largest difference of the cumulatives", h.kolmogorov);
  return t;
}

}  // namespace jalon
