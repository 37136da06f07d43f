// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/result/residuals.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>

#include "base/parallel.h"
#include "base/table_columns.h"

namespace jalon {

namespace {

constexpr size_t kGrain = 65536;
constexpr double kRangeInSigmas = 4;
constexpr double kSmallestRange_m = 1e-6;

// Sums of powers about a fixed value.
struct Sums {
  uint64_t n = 0;
  double first = 0, second = 0, third = 0, fourth = 0;
  void add(double d) {
    ++n;
    first += d;
    second += d * d;
    third += d * d * d;
    fourth += d * d * d * d;
  }
  Sums& operator+=(const Sums& b) {
    n += b.n;
    first += b.first;
    second += b.second;
    third += b.third;
    fourth += b.fourth;
    return *this;
  }
};

struct Counts {
  uint64_t below = 0, above = 0;
  std::vector<uint64_t> bins;
  Counts& operator+=(const Counts& b) {
    below += b.below;
    above += b.above;
    for (size_t i = 0; i < bins.size(); ++i) bins[i] += b.bins[i];
    return *this;
  }
};

// Half a millimetre steps up to a round number, so that the axis ends on a mark.
double round_range(double value_m) {
  const double power = std::pow(10, std::floor(std::log10(value_m)));
  return std::ceil(value_m / power * 2 - 1e-9) / 2 * power;
}

// The residuals of one segment, or of all.
class Selection {
 public:
  Selection(const Segmentation& segmentation, uint32_t label)
      : residuals_(segmentation.residuals->values<float>()),
        labels_(segmentation.labels->values<uint32_t>()),
        label_(label) {}

  size_t size() const { return residuals_.size(); }
  template <class F>
  void for_each(size_t begin, size_t end, F&& f) const {
    for (size_t i = begin; i < end; ++i) {
      const auto r = static_cast<double>(residuals_[i]);
      if (std::isfinite(r) && (label_ == 0 || labels_[i] == label_)) f(r);
    }
  }
  Sums sums_about(double value, Task& task) const {
    return parallel_reduce(task, size(), kGrain, Sums{}, [&](size_t begin, size_t end) {
      Sums s;
      for_each(begin, end, [&](double r) { s.add(r - value); });
      return s;
    });
  }

 private:
  std::span<const float> residuals_;
  std::span<const uint32_t> labels_;
  uint32_t label_;
};

void fit_normal(const Selection& selection, Residuals& out, Task& task) {
  const Sums plain = selection.sums_about(0, task);
  out.count = plain.n;
  if (plain.n == 0) return;
  const double n = static_cast<double>(plain.n);
  out.mean_m = plain.first / n;
  const Sums central = selection.sums_about(out.mean_m, task);  // a second pass: no cancellation
  const double variance = central.second / n;
  out.sigma_m = plain.n > 1 ? std::sqrt(central.second / (n - 1)) : 0;
  if (variance <= 0) return;
  out.skewness = central.third / n / (variance * std::sqrt(variance));
  out.excess_kurtosis = central.fourth / n / (variance * variance) - 3;
}

}  // namespace

double Residuals::expected(double value_m) const {
  if (sigma_m <= 0) return 0;
  const double t = (value_m - mean_m) / sigma_m;
  return static_cast<double>(count) * bin_width_m() / (sigma_m * std::sqrt(2 * std::numbers::pi)) *
         std::exp(-0.5 * t * t);
}

Residuals bin_residuals(const Segmentation& segmentation, uint32_t label, size_t bins, Task& task) {
  const Selection selection(segmentation, label);
  Residuals out;
  out.bins.assign(bins, 0);
  fit_normal(selection, out, task);
  if (out.count == 0) return out;
  out.half_range_m =
      round_range(std::max(kRangeInSigmas * out.sigma_m + std::fabs(out.mean_m), kSmallestRange_m));
  const double scale = static_cast<double>(bins) / (2 * out.half_range_m);
  Counts zero;
  zero.bins.assign(bins, 0);
  const Counts counts =
      parallel_reduce(task, selection.size(), kGrain, zero, [&](size_t begin, size_t end) {
        Counts c = zero;
        selection.for_each(begin, end, [&](double r) {
          const double at = std::floor((r + out.half_range_m) * scale);
          if (at < 0) ++c.below;
          else if (at >= static_cast<double>(bins)) ++c.above;
          else ++c.bins[static_cast<size_t>(at)];
        });
        return c;
      });
  out.below = counts.below;
  out.above = counts.above;
  out.bins = counts.bins;
  return out;
}

FieldTable residual_bins_table(const Residuals& r) {
  std::vector<double> lower, upper, expected;
  const double width = r.bin_width_m();
  for (size_t i = 0; i < r.bins.size(); ++i) {
    lower.push_back(-r.half_range_m + static_cast<double>(i) * width);
    upper.push_back(-r.half_range_m + static_cast<double>(i + 1) * width);
    expected.push_back(r.expected(lower.back() + width / 2));
  }
  FieldTable table;
  const auto same = [](auto value) { return value; };
  add_column<double>(table, lower, "lower", "m", "lower limit of the bin", same);
  add_column<double>(table, upper, "upper", "m", "upper limit of the bin", same);
  add_column<uint64_t>(table, r.bins, "count", "points", "points in the bin", same);
  add_column<double>(table, expected, "expected", "points", "the same if the distances were normal",
                     same);
  return table;
}

FieldTable residual_normal_table(const Residuals& r) {
  FieldTable table;
  add_value<uint64_t>(table, "count", "points", "points with a plane", r.count);
  add_value<double>(table, "mean", "m", "mean distance", r.mean_m);
  add_value<double>(table, "sigma", "m", "standard deviation", r.sigma_m);
  add_value<double>(table, "skewness", "", "0 for a normal distribution", r.skewness);
  add_value<double>(table, "excess_kurtosis", "", "0 for a normal distribution", r.excess_kurtosis);
  add_value<uint64_t>(table, "below", "points", "below the first bin", r.below);
  add_value<uint64_t>(table, "above", "points", "above the last bin", r.above);
  return table;
}

}  // namespace jalon
