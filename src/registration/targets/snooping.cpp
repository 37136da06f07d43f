// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/snooping.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/distributions.h"
#include "geometry/symmetric_eigen.h"

namespace jalon {

namespace {

constexpr double kUncontrolled =
    1e-9;  // redundancy below which no other target controls a direction
constexpr double kRounding =
    1e-24;  // squares this small against the weights are rounding: nothing to test
constexpr int kHalvings = 40;  // of an interval: to twelve digits
constexpr double kMostNoncentrality =
    1000;                            // a blunder of 30 standard deviations, or none at all will do
constexpr size_t kMostTerms = 2000;  // of a Poisson mixture with a mean below 500
constexpr double kNegligible = 1e-12;  // weight of the terms left

Vec3 times_of_snooping(const Square<3>& m, const Vec3& v) {
  return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
          m[6] * v.x + m[7] * v.y + m[8] * v.z};
}

// The quadratic form v^T M^+ v and the rank of M, both in units where W is the identity: M is at most W.
double controlled_form(const Square<3>& whole, const Square<3>& controlled, const Vec3& v,
                       int& rank) {
  // L^-1 M L^-T with W = L L^T has eigenvalues between 0 and 1: the redundancies along its own axes.
  Square<3> l{};
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j <= i; ++j) {
      double sum = whole[3 * i + j];
      for (size_t k = 0; k < j; ++k) sum -= l[3 * i + k] * l[3 * j + k];
      l[3 * i + j] = i == j ? std::sqrt(std::max(sum, 0.0)) : sum / l[3 * j + j];
    }
  const auto forward = [&](Vec3 x) {
    x.x /= l[0];
    x.y = (x.y - l[3] * x.x) / l[4];
    x.z = (x.z - l[6] * x.x - l[7] * x.y) / l[8];
    return x;
  };
  Square<3> half{}, form{};
  for (size_t c = 0; c < 3; ++c) {
    const Vec3 column = forward({controlled[c], controlled[3 + c], controlled[6 + c]});
    for (size_t r = 0; r < 3; ++r) half[3 * r + c] = column[static_cast<int>(r)];
  }
  for (size_t r = 0; r < 3; ++r) {
    const Vec3 row = forward({half[3 * r], half[3 * r + 1], half[3 * r + 2]});
    for (size_t c = 0; c < 3; ++c) form[3 * r + c] = row[static_cast<int>(c)];
  }
  const Eigen3 eigen = symmetric_eigen({form[0], form[1], form[2], form[4], form[5], form[8]});
  const Vec3 white = forward(v);
  rank = 0;
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    if (!(eigen.values[i] > kUncontrolled)) continue;
    ++rank;
    const double part = dot(eigen.vectors[i], white);
    sum += part * part / eigen.values[i];
  }
  return sum;
}

}  // namespace

Snooping::Snooping(const SnoopingSettings& setting, double weighted_squares, int redundancy)
    : setting_(setting), weighted_squares_(weighted_squares), redundancy_(redundancy) {
  if (setting.estimated()) sigma0_ = redundancy > 0 ? std::sqrt(weighted_squares / redundancy) : 0;
  for (int q = 1; q <= 3; ++q) needed_[static_cast<size_t>(q)] = noncentrality(q);
}

// Known sigma0: chi-square. Estimated: its share of all squares follows a beta distribution; for one dimension this is
// Pope's tau test (1976).
double Snooping::tail(double critical, int dimensions, int more) const {
  const double q = dimensions + 2 * more;
  if (!setting_.estimated()) return chi_square_tail(q, critical);
  return beta_tail(q / 2, (redundancy_ - dimensions) / 2.0, std::clamp(critical, 0.0, 1.0));
}

double Snooping::p_value(double statistic, int dimensions) const {
  if (dimensions == 0 || weighted_squares_ <= kRounding) return 1;
  if (!setting_.estimated()) return tail(statistic, dimensions, 0);
  return redundancy_ > dimensions ? tail(statistic / weighted_squares_, dimensions, 0) : 1;
}

// Independent of the adjusted squares: an F test, as a share of both sums.
double Snooping::prediction_p_value(double statistic, int dimensions) const {
  if (!setting_.estimated()) return chi_square_tail(dimensions, statistic);
  if (!(redundancy_ > 0 && statistic > 0)) return 1;
  const double share = statistic / (statistic + weighted_squares_);
  return beta_tail(dimensions / 2.0, redundancy_ / 2.0, std::min(share, 1.0));
}

double Snooping::critical(int dimensions) const {
  if (!setting_.estimated()) return chi_square_upper_quantile(dimensions, setting_.significance);
  double low = 0, high = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (tail(middle, dimensions, 0) > setting_.significance ? low : high) = middle;
  }
  return high;
}

// The power is a Poisson mixture of central tails (Johnson, Kotz & Balakrishnan 1995, 29.2).
double Snooping::noncentrality(int dimensions) const {
  if (setting_.estimated() && redundancy_ <= dimensions) return INFINITY;
  const double limit = critical(dimensions);
  std::vector<double> tails;
  const auto power = [&](double lambda) {
    double sum = 0, left = 1, weight = std::exp(-lambda / 2);
    for (size_t k = 0; k < kMostTerms && left > kNegligible; ++k) {
      if (k == tails.size()) tails.push_back(tail(limit, dimensions, static_cast<int>(k)));
      sum += weight * tails[k];
      left -= weight;
      weight *= lambda / 2 / static_cast<double>(k + 1);
    }
    return sum;
  };
  double low = 0, high = 1;
  while (power(high) < setting_.power) {
    low = high;
    high *= 2;
    if (high > kMostNoncentrality) return INFINITY;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (power(middle) < setting_.power ? low : high) = middle;
  }
  return high;
}

TargetTest Snooping::test(const PairResidual& pair) const {
  TargetTest out;
  const Square<3> controlled = sandwich<3>(pair.weight, pair.cofactor);  // P Q_e P
  const Vec3 weighted = times_of_snooping(pair.weight, pair.residual_m);
  out.statistic = controlled_form(pair.weight, controlled, weighted, out.dimensions);
  out.p_value = p_value(out.statistic, out.dimensions);
  out.outlier = out.p_value < setting_.significance;
  const double needed = needed_[static_cast<size_t>(out.dimensions)];
  for (size_t i = 0; i < 3; ++i) {
    for (size_t k = 0; k < 3; ++k)
      out.redundancy[i] += pair.cofactor[3 * i + k] * pair.weight[3 * k + i];
    const double control = controlled[4 * i];
    const bool seen = out.dimensions > 0 && control > kUncontrolled * pair.weight[4 * i];
    if (seen && sigma0_ > 0)
      out.normalised[i] = weighted[static_cast<int>(i)] / (std::sqrt(control) * sigma0_);
    out.detectable_m[i] = seen ? sigma0_ * std::sqrt(needed / control) : INFINITY;
  }
  return out;
}

TargetTest Snooping::test_prediction(const Vec3& residual_m, const Square<3>& cofactor) const {
  TargetTest out;
  Cholesky<3> factor;
  if (!factor.factor(cofactor)) return out;
  const Coefficients<3> x = factor.solve({residual_m.x, residual_m.y, residual_m.z});
  out.dimensions = 3;
  out.statistic = residual_m.x * x[0] + residual_m.y * x[1] + residual_m.z * x[2];
  out.p_value = prediction_p_value(out.statistic, 3);
  out.outlier = out.p_value < setting_.significance;
  const Square<3> inverse = factor.inverse();
  for (size_t i = 0; i < 3; ++i) {
    out.redundancy[i] = 1;
    if (sigma0_ > 0)
      out.normalised[i] = residual_m[static_cast<int>(i)] / (std::sqrt(cofactor[4 * i]) * sigma0_);
    out.detectable_m[i] = sigma0_ * std::sqrt(needed_[3] / inverse[4 * i]);
  }
  return out;
}

double variance_factor_p_value(double weighted_squares, int redundancy) {
  if (redundancy < 1) return 1;
  const double above = chi_square_tail(redundancy, weighted_squares);
  return 2 * std::min(above, 1 - above);
}

}  // namespace jalon
