// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/chi_square.h"

#include <algorithm>
#include <cmath>

#include "base/distributions.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kChiSquareGrain = 1 << 14;
constexpr uint32_t kChiSquareMostClasses = 1000;

struct Counts {
  std::vector<uint64_t> of;
  Counts& operator+=(const Counts& b) {
    for (size_t i = 0; i < of.size(); ++i) of[i] += b.of[i];
    return *this;
  }
};

}  // namespace

uint32_t classes_for(size_t n, uint32_t most) {
  auto k = static_cast<uint32_t>(std::sqrt(static_cast<double>(n)));
  return std::clamp(k, 2u, most);
}

ChiSquareDistance chi_square_distance(std::span<const double> values, const NoiseLaw& law,
                                      uint32_t classes, Task& task) {
  ChiSquareDistance out;
  out.classes = classes >= 2 ? classes : classes_for(values.size(), kChiSquareMostClasses);
  const Counts counts = parallel_reduce(
      task, values.size(), kChiSquareGrain, Counts{std::vector<uint64_t>(out.classes)},
      [&](size_t begin, size_t end) {
        Counts part{std::vector<uint64_t>(out.classes)};
        for (size_t i = begin; i < end; ++i) {
          const double u = law.cumulative(values[i]);
          ++part.of[std::min(out.classes - 1, static_cast<uint32_t>(u * out.classes))];
        }
        return part;
      });
  const double expected = static_cast<double>(values.size()) / out.classes;
  for (const uint64_t count : counts.of) {
    const double d = static_cast<double>(count) - expected;
    out.distance += d * d / expected;
  }
  out.p_value = chi_square_tail(out.classes - 1, out.distance);
  return out;
}

double chi_square_threshold(uint32_t classes, double error_margin) {
  return chi_square_upper_quantile(classes - 1, error_margin);
}

double kolmogorov_threshold(size_t n, uint64_t m, double error_margin) {
  const double c = std::sqrt(-0.5 * std::log(0.5 * error_margin));
  return c * std::sqrt(1 / static_cast<double>(n) + (m > 0 ? 1 / static_cast<double>(m) : 0));
}

double kolmogorov_distance(std::span<double> cumulative) {
  // Those of ascending values ascend already, but for rounding.
  if (!std::is_sorted(cumulative.begin(), cumulative.end()))
    std::sort(cumulative.begin(), cumulative.end());
  const auto n = static_cast<double>(cumulative.size());
  double most = 0;
  for (size_t i = 0; i < cumulative.size(); ++i) {
    const auto below = static_cast<double>(i);
    most = std::max({most, (below + 1) / n - cumulative[i], cumulative[i] - below / n});
  }
  return most;
}

}  // namespace jalon
