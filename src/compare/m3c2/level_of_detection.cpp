// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/level_of_detection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/distributions.h"
#include "base/error.h"

namespace jalon {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double quantile_of(std::span<const double> ascending, double p) {
  const double at = p * static_cast<double>(ascending.size() - 1);
  const auto i = static_cast<size_t>(at);
  if (i + 1 >= ascending.size()) return ascending.back();
  return ascending[i] + (at - static_cast<double>(i)) * (ascending[i + 1] - ascending[i]);
}

double median_dof(double n) { return std::sqrt(n) + 2; }

double squared_deviations(std::span<const double> values, double about) {
  double sum = 0;
  for (const double v : values) sum += (v - about) * (v - about);
  return sum;
}

}  // namespace

double variance_of_median(double variance, size_t n) {
  return variance * std::numbers::pi / 2 / (static_cast<double>(n) + (n % 2 == 1 ? 0.46 : 1.36));
}

SurfacePosition mean_position(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0;
  for (const double v : values) sum += v;
  const double mean = sum / n;
  const double variance = squared_deviations(values, mean) / (n - 1);
  return {mean, std::sqrt(variance), variance / n, n - 1};
}

MedianEstimator::Order MedianEstimator::order_for(size_t n) {
  const auto size = static_cast<double>(n);
  const double rank = std::max(1.0, std::round((size + 1) / 2 - std::sqrt(size)));
  const double sigma_of_median = std::sqrt(variance_of_median(1, n));
  const double expected = -2 * normal_quantile((rank - 0.375) / (size + 0.25));
  const double root_mean_square = expected * std::sqrt(1 + 0.5 / median_dof(size));
  return {static_cast<size_t>(rank) - 1, sigma_of_median / root_mean_square};
}

MedianEstimator::MedianEstimator() {
  constexpr size_t kTabled = 512;
  table_.resize(kTabled);
  for (size_t n = 2; n < kTabled; ++n) table_[n] = order_for(n);
}

SurfacePosition MedianEstimator::operator()(std::span<const double> ascending) const {
  constexpr double kNormalQuartiles = 1.3489795003921634;  // 2 Phi^-1(0.75)
  const size_t n = ascending.size();
  const Order order = n < table_.size() ? table_[n] : order_for(n);
  const auto size = static_cast<double>(n);
  SurfacePosition out;
  out.position_m = n % 2 == 1 ? ascending[n / 2] : 0.5 * (ascending[n / 2 - 1] + ascending[n / 2]);
  out.spread_m = (quantile_of(ascending, 0.75) - quantile_of(ascending, 0.25)) / kNormalQuartiles;
  const double sigma = (ascending[n - 1 - order.rank] - ascending[order.rank]) * order.factor;
  out.variance_m2 = sigma * sigma;
  out.dof = median_dof(size);
  if (sigma ==
      0) {  // rounded values, all alike in the middle: what is left is the variance of a normal sample
    out.variance_m2 =
        variance_of_median(squared_deviations(ascending, out.position_m) / (size - 1), n);
    out.dof = size - 1;
  }
  return out;
}

RigidUncertainty::RigidUncertainty(std::span<const double> covariance36, const Vec3& centre)
    : centre_(centre) {
  std::copy_n(covariance36.begin(), covariance_.size(), covariance_.begin());
}

double RigidUncertainty::variance_along(const Vec3& place, const Vec3& normal) const {
  const Vec3 turn = cross(place - centre_, normal);
  const double j[6] = {turn.x, turn.y, turn.z, normal.x, normal.y, normal.z};
  double sum = 0;
  for (size_t r = 0; r < 6; ++r)
    for (size_t c = 0; c < 6; ++c) sum += j[r] * covariance_[6 * r + c] * j[c];
  return std::max(0.0, sum);
}

LevelOfDetection::LevelOfDetection(double confidence) {
  constexpr size_t kCells =
      1024;  // cubic between them: 1e-9 of a quantile, 1e-7 below three degrees of freedom
  const double p = 0.5 + 0.5 * confidence;
  table_.resize(kCells + 1);
  table_[0] = normal_quantile(p);
  for (size_t i = 1; i < table_.size(); ++i)
    table_[i] = student_quantile(static_cast<double>(kCells) / static_cast<double>(i), p);
}

// Lagrange's cubic through the four nodes around, over 1 / dof: smooth, and 0 for the normal distribution.
double LevelOfDetection::quantile(double dof) const {
  const size_t last = table_.size() - 1;
  const double at = std::min(1.0, 1 / dof) * static_cast<double>(last);
  const size_t first = std::clamp<size_t>(static_cast<size_t>(at), 1, last - 2) - 1;
  const double x = at - static_cast<double>(first);
  const double* y = table_.data() + first;
  return ((x - 1) * (x - 2) * (x - 3) * y[0] - 3 * x * (x - 2) * (x - 3) * y[1] +
          3 * x * (x - 1) * (x - 3) * y[2] - x * (x - 1) * (x - 2) * y[3]) /
         -6;
}

double LevelOfDetection::level_m(const SurfacePosition& a, const SurfacePosition& b,
                                 double registration_error_m,
                                 double registration_variance_m2) const {
  const double sampled =
      a.variance_m2 * a.variance_m2 / a.dof + b.variance_m2 * b.variance_m2 / b.dof;
  const double variance = a.variance_m2 + b.variance_m2 + registration_variance_m2;
  const double dof = sampled > 0 ? variance * variance / sampled : kInfinity;
  return quantile(dof) * std::sqrt(variance) + table_[0] * registration_error_m;
}

}  // namespace jalon
