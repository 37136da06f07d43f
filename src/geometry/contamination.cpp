// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/contamination.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kNodesPerSigma = 12;  // linear between them: right to 0.001 of the density
constexpr double kLeastDensity = 1e-300;
constexpr double kSqrtHalf = 0.70710678118654752440;
constexpr double kOneOverSqrtTwoPi = 0.39894228040143267794;

double normal_density(double z) { return kOneOverSqrtTwoPi * std::exp(-0.5 * z * z); }
double normal_distribution(double z) { return 0.5 * std::erfc(-z * kSqrtHalf); }

/// A density and its derivatives by r and s = ln sigma.
struct Kind {
  double f, r, s, rr, rs, ss;
};

Kind core_kind(double r, const Contamination& c) {
  const double sigma = c.sigma_m, k = c.tolerance_m / sigma, q = r * r / (sigma * sigma);
  const double lost = lost_by_truncation(c.tolerance_m, sigma),
               more_lost = lost * (k * k - 1) + lost * lost;
  const double f = normal_density(r / sigma) / (sigma * (2 * normal_distribution(k) - 1));
  const double inverse = 1 / (sigma * sigma), by_s = q - 1 + lost;
  // The cut moves with the plane: that takes its part from the curvature along r.
  return {f,
          -r * inverse * f,
          by_s * f,
          (q - 1 + lost) * inverse * f,
          (2 - by_s) * r * inverse * f,
          (by_s * by_s - 2 * q + more_lost) * f};
}

Kind front_kind(double r, const Contamination& c) {
  const double z = r / c.sigma_m;
  const double g = normal_density(z) / (c.sigma_m * c.tolerance_m);
  return {normal_distribution(z) / c.tolerance_m,
          g,
          -r * g,
          -z * g / c.sigma_m,
          g * (z * z - 1),
          -r * g * (z * z - 1)};
}

Kind mirrored(const Kind& front, const Contamination& c) {
  return {1 / c.tolerance_m - front.f, -front.r, -front.s, -front.rr, -front.rs, -front.ss};
}

/// All that is known at one distance.
struct Mixture {
  Kind core, front, behind;
  double shares[3];
  double density;

  Mixture(double r, const Contamination& c)
      : core(core_kind(r, c)),
        front(front_kind(r, c)),
        behind(mirrored(front, c)),
        shares{c.core(), c.front, c.behind},
        density(std::max(mixed(&Kind::f), kLeastDensity)) {}
  double mixed(double Kind::*part) const {
    return shares[0] * core.*part + shares[1] * front.*part + shares[2] * behind.*part;
  }
};

ContaminationTable::Weights weights_at(const Mixture& m) {
  return {m.shares[0] * m.core.f / m.density, m.shares[1] * m.front.f / m.density,
          m.shares[2] * m.behind.f / m.density, std::log(m.density), m.mixed(&Kind::r) / m.density};
}

ContaminationTable::Derivatives derivatives_at(const Mixture& m) {
  using T = ContaminationTable;
  const Kind &n = m.core, &f = m.front, &b = m.behind;
  const double d = m.density;
  const double by_r = m.mixed(&Kind::r) / d, by_s = m.mixed(&Kind::s) / d;
  const double by_f = (f.f - n.f) / d, by_b = (b.f - n.f) / d;
  T::Derivatives v{};
  v[T::kR] = by_r, v[T::kS] = by_s, v[T::kF] = by_f, v[T::kB] = by_b;
  v[T::kRR] = m.mixed(&Kind::rr) / d - by_r * by_r;
  v[T::kRS] = m.mixed(&Kind::rs) / d - by_r * by_s;
  v[T::kSS] = m.mixed(&Kind::ss) / d - by_s * by_s;
  v[T::kRF] = (f.r - n.r) / d - by_r * by_f;
  v[T::kRB] = (b.r - n.r) / d - by_r * by_b;
  v[T::kSF] = (f.s - n.s) / d - by_s * by_f;
  v[T::kSB] = (b.s - n.s) / d - by_s * by_b;
  v[T::kFF] = -by_f * by_f, v[T::kFB] = -by_f * by_b, v[T::kBB] = -by_b * by_b;
  return v;
}

}  // namespace

double lost_by_truncation(double tolerance_m, double sigma_m) {
  const double k = tolerance_m / sigma_m;
  return 2 * k * normal_density(k) / (2 * normal_distribution(k) - 1);
}

ContaminationTable::ContaminationTable(const Contamination& c, bool with_derivatives)
    : tolerance_m_(c.tolerance_m) {
  const double intervals = 2 * std::ceil(kNodesPerSigma * c.tolerance_m / c.sigma_m);
  per_m_ = intervals / (2 * c.tolerance_m);
  const size_t nodes = static_cast<size_t>(intervals) + 1;
  weights_.resize(nodes);
  if (with_derivatives) derivatives_.resize(nodes);
  for (size_t i = 0; i < nodes; ++i) {
    const Mixture mixture(static_cast<double>(i) / per_m_ - tolerance_m_, c);
    weights_[i] = weights_at(mixture);
    if (with_derivatives) derivatives_[i] = derivatives_at(mixture);
  }
}

ContaminationTable::Derivatives ContaminationTable::derivatives(double r) const {
  const auto [node, t] = place(r);
  Derivatives out;
  for (size_t k = 0; k < kDerivatives; ++k)
    out[k] = derivatives_[node][k] + t * (derivatives_[node + 1][k] - derivatives_[node][k]);
  return out;
}

}  // namespace jalon
