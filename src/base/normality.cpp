// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/normality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/distributions.h"
#include "base/error.h"
#include "base/numbers.h"

namespace jalon {

namespace {

// Ascending powers.
template <size_t N>
double polynomial(const std::array<double, N>& c, double x) {
  double sum = 0;
  for (size_t k = N; k-- > 0;) sum = sum * x + c[k];
  return sum;
}

// The coefficients of the upper half of the sorted sample, the largest value's first (Royston 1995).
std::vector<double> royston_coefficients(uint64_t n) {
  const size_t half = static_cast<size_t>(n / 2);
  if (n == 3) return {std::numbers::sqrt2 / 2};
  constexpr std::array<double, 6> kFirst = {0, .221157, -.147981, -2.07119, 4.434685, -2.706056};
  constexpr std::array<double, 6> kSecond = {0, .042981, -.293762, -1.752461, 5.682633, -3.582633};
  // 1. Expected places of the values, nearly (Blom 1958), negative.
  std::vector<double> m(half);
  double sum = 0;
  for (size_t i = 0; i < half; ++i) {
    m[i] = normal_quantile((static_cast<double>(i) + 0.625) / (static_cast<double>(n) + 0.25));
    sum += 2 * m[i] * m[i];
  }
  // 2. The outermost by polynomials, the others in proportion so that the squares sum to 1.
  const double u = 1 / std::sqrt(static_cast<double>(n)), length = std::sqrt(sum);
  std::vector<double> a(half);
  a[0] = polynomial(kFirst, u) - m[0] / length;
  size_t given = 1;
  double rest = sum - 2 * m[0] * m[0], share = 1 - 2 * a[0] * a[0];
  if (n > 5) {
    a[1] = polynomial(kSecond, u) - m[1] / length;
    rest -= 2 * m[1] * m[1];
    share -= 2 * a[1] * a[1];
    given = 2;
  }
  const double factor = std::sqrt(rest / share);
  for (size_t i = given; i < half; ++i) a[i] = -m[i] / factor;
  return a;
}

std::vector<double> sorted_values(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

double quantile_of(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const size_t below = static_cast<size_t>(at), above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

SampleStatistics sample_statistics(std::span<const double> values) {
  const std::vector<double> sorted = sorted_values(values);
  const double n = static_cast<double>(sorted.size());
  SampleStatistics s;
  s.count = sorted.size();
  for (const double v : sorted) s.mean += v / n;
  double second = 0, third = 0, fourth = 0;
  for (const double v : sorted) {
    const double d = v - s.mean;
    second += d * d;
    third += d * d * d;
    fourth += d * d * d * d;
  }
  s.median = quantile_of(sorted, 0.5);
  s.range = sorted.back() - sorted.front();
  s.quartile_range = quantile_of(sorted, 0.75) - quantile_of(sorted, 0.25);
  s.variance = n > 1 ? second / (n - 1) : kNaN;
  s.deviation = std::sqrt(s.variance);
  const double m2 = second / n;
  s.skewness =
      n > 2 && m2 > 0 ? third / n / std::pow(m2, 1.5) * std::sqrt(n * (n - 1)) / (n - 2) : kNaN;
  s.kurtosis = n > 3 && m2 > 0
                   ? (n - 1) / ((n - 2) * (n - 3)) * ((n + 1) * (fourth / n / (m2 * m2) - 3) + 6)
                   : kNaN;
  return s;
}

double shapiro_wilk_p(double one_less_W, uint64_t count) {
  const double n = static_cast<double>(count);
  if (count == 3) {  // exact
    const double least = std::asin(std::sqrt(0.75));
    return std::max(0.0, 6 / std::numbers::pi * (std::asin(std::sqrt(1 - one_less_W)) - least));
  }
  double y = std::log(one_less_W), mean = 0, deviation = 0;
  if (count <= 11) {
    constexpr std::array<double, 4> kMean = {.544, -.39978, .025054, -6.714e-4};
    constexpr std::array<double, 4> kDeviation = {1.3822, -.77857, .062767, -.0020322};
    const double gamma = -2.273 + 0.459 * n;
    if (y >= gamma) return 0;
    y = -std::log(gamma - y);
    mean = polynomial(kMean, n);
    deviation = std::exp(polynomial(kDeviation, n));
  } else {
    constexpr std::array<double, 4> kMean = {-1.5861, -.31082, -.083751, .0038915};
    constexpr std::array<double, 3> kDeviation = {-.4803, -.082676, .0030302};
    const double x = std::log(n);
    mean = polynomial(kMean, x);
    deviation = std::exp(polynomial(kDeviation, x));
  }
  return normal_cdf(-(y - mean) / deviation);
}

ShapiroWilk shapiro_wilk(std::span<const double> values) {
  const uint64_t n = values.size();
  if (n < kLeastShapiroWilk)
    fail(Status::kInsufficientData, "a test of normality needs 3 values, there are %llu",
         static_cast<unsigned long long>(n));
  if (n > kMostShapiroWilk)
    fail(Status::kLimit,
         "the p-value of Shapiro and Wilk's test holds up to 5000 values, not for %llu",
         static_cast<unsigned long long>(n));
  const std::vector<double> sorted = sorted_values(values);
  const double range = sorted.back() - sorted.front();
  if (!(range > 0))
    fail(Status::kDegenerate, "all %llu values are equal: no test of normality",
         static_cast<unsigned long long>(n));
  // In units of the range about the mean, as AS R94 has it. 1 - W = (1 - r)(1 + r), r the correlation
  // with the coefficients: each factor keeps its digits near W = 1.
  double mean = 0;
  for (const double v : sorted) mean += (v - sorted.front()) / range / static_cast<double>(n);
  double squares = 0, numerator = 0;
  for (const double v : sorted) {
    const double d = (v - sorted.front()) / range - mean;
    squares += d * d;
  }
  const std::vector<double> a = royston_coefficients(n);
  double a_squares = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    numerator += a[i] * (sorted[n - 1 - i] - sorted[i]) / range;
    a_squares += 2 * a[i] * a[i];
  }
  const double root = std::sqrt(a_squares * squares);
  const double one_less_W =
      std::clamp((root - numerator) * (root + numerator) / (a_squares * squares), 1e-19, 1.0);
  return {1 - one_less_W, shapiro_wilk_p(one_less_W, n)};
}

}  // namespace jalon
