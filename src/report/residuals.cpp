// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/residuals.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kGrain = 65536;
constexpr double kRangeInSigmas = 4;
constexpr double kSmallestRange_m = 1e-6;

struct Sums {
  uint64_t n = 0;
  double sum = 0, squares = 0;
  Sums& operator+=(const Sums& b) {
    n += b.n;
    sum += b.sum;
    squares += b.squares;
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

}  // namespace

Residuals bin_residuals(const Segmentation& segmentation, size_t bins, Task& task) {
  Residuals out;
  out.bins.assign(bins, 0);
  const auto values = segmentation.residuals->values<float>();
  const Sums sums = parallel_reduce(task, values.size(), kGrain, Sums{}, [&](size_t begin, size_t end) {
    Sums s;
    for (size_t i = begin; i < end; ++i) {
      const double r = static_cast<double>(values[i]);
      if (!std::isfinite(r)) continue;
      ++s.n;
      s.sum += r;
      s.squares += r * r;
    }
    return s;
  });
  out.count = sums.n;
  if (sums.n == 0) return out;
  const double n = static_cast<double>(sums.n);
  out.mean_m = sums.sum / n;
  out.sigma_m = std::sqrt(std::max(0.0, sums.squares / n - out.mean_m * out.mean_m));
  out.half_range_m = round_range(std::max(kRangeInSigmas * out.sigma_m + std::fabs(out.mean_m), kSmallestRange_m));
  const double scale = static_cast<double>(bins) / (2 * out.half_range_m);
  Counts zero;
  zero.bins.assign(bins, 0);
  const Counts counts = parallel_reduce(task, values.size(), kGrain, zero, [&](size_t begin, size_t end) {
    Counts c = zero;
    for (size_t i = begin; i < end; ++i) {
      const double r = static_cast<double>(values[i]);
      if (!std::isfinite(r)) continue;
      const double at = std::floor((r + out.half_range_m) * scale);
      if (at < 0)
        ++c.below;
      else if (at >= static_cast<double>(bins))
        ++c.above;
      else
        ++c.bins[static_cast<size_t>(at)];
    }
    return c;
  });
  out.below = counts.below;
  out.above = counts.above;
  out.bins = counts.bins;
  return out;
}

}  // namespace jalon
