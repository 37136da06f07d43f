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

/// What is the same at all distances.
struct Cut {
  double k, kept, lost;  ///< tolerance / sigma; 2 Phi(k) - 1; see lost_by_truncation()

  explicit Cut(const Contamination& c)
      : k(c.tolerance_m / c.sigma_m),
        kept(2 * normal_distribution(k) - 1),
        lost(2 * k * normal_density(k) / kept) {}
};

Kind core_kind(double r, double density, const Contamination& c, const Cut& cut) {
  const double sigma = c.sigma_m, k = cut.k, q = r * r / (sigma * sigma);
  const double lost = cut.lost, more_lost = lost * (k * k - 1) + lost * lost;
  const double f = density / (sigma * cut.kept);
  const double inverse = 1 / (sigma * sigma), by_s = q - 1 + lost;
  // The cut moves with the plane: that takes its part from the curvature along r.
  return {f,
          -r * inverse * f,
          by_s * f,
          (q - 1 + lost) * inverse * f,
          (2 - by_s) * r * inverse * f,
          (by_s * by_s - 2 * q + more_lost) * f};
}

Kind front_kind(double r, double density, const Contamination& c) {
  const double z = r / c.sigma_m;
  const double g = density / (c.sigma_m * c.tolerance_m);
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

/// What is mixed at one distance.
struct Kinds {
  Kind core, front, behind;

  Kinds(double r, const Contamination& c, const Cut& cut)
      : Kinds(r, normal_density(r / c.sigma_m), c, cut) {}

 private:
  Kinds(double r, double normal, const Contamination& c, const Cut& cut)
      : core(core_kind(r, normal, c, cut)),
        front(front_kind(r, normal, c)),
        behind(mirrored(front, c)) {}
};

/// All that is known at one distance.
struct Mixture {
  const Kind &core, &front, &behind;
  double shares[3];
  double density;

  Mixture(const Kinds& kinds, const Contamination& c)
      : core(kinds.core),
        front(kinds.front),
        behind(kinds.behind),
        shares{c.core(), c.front, c.behind},
        density(std::max(mixed(&Kind::f), kLeastDensity)) {}
  double mixed(double Kind::*part) const {
    return shares[0] * core.*part + shares[1] * front.*part + shares[2] * behind.*part;
  }
};

ContaminationTable::Weights weights_at(const Mixture& m) {
  return {m.shares[0] * m.core.f / m.density, m.shares[1] * m.front.f / m.density,
          m.shares[2] * m.behind.f / m.density, m.mixed(&Kind::r) / m.density};
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

ContaminationTable::ContaminationTable(double tolerance_m, double sigma_m)
    : tolerance_m_(tolerance_m) {
  intervals_ = 2 * std::ceil(kNodesPerSigma * tolerance_m / sigma_m);
  last_interval_ = static_cast<int32_t>(intervals_) - 1;
  per_m_ = intervals_ / (2 * tolerance_m);
  weights_.resize(static_cast<size_t>(intervals_) + 1);
}

ContaminationTable::ContaminationTable(const Contamination& c, With with)
    : ContaminationTable(of_zones({&c, 1}, with)[0]) {}

std::vector<ContaminationTable> ContaminationTable::of_zones(std::span<const Contamination> zones,
                                                             With with) {
  const double tolerance_m = zones[0].tolerance_m;
  std::vector<ContaminationTable> tables(zones.size(),
                                         ContaminationTable(tolerance_m, zones[0].sigma_m));
  const Cut cut(zones[0]);
  const size_t nodes = tables[0].weights_.size();
  for (ContaminationTable& table : tables) {
    if (with != With::kWeightsAlone) table.log_densities_.resize(nodes);
    if (with == With::kDerivatives) table.derivatives_.resize(nodes);
  }
  for (size_t i = 0; i < nodes; ++i) {
    const Kinds kinds(static_cast<double>(i) / tables[0].per_m_ - tolerance_m, zones[0], cut);
    for (size_t z = 0; z < zones.size(); ++z) {
      const Mixture mixture(kinds, zones[z]);
      tables[z].weights_[i] = weights_at(mixture);
      if (with != With::kWeightsAlone) tables[z].log_densities_[i] = std::log(mixture.density);
      if (with == With::kDerivatives) tables[z].derivatives_[i] = derivatives_at(mixture);
    }
  }
  return tables;
}

ContaminationTable::Derivatives ContaminationTable::derivatives(double r) const {
  const auto [node, t] = place(r);
  Derivatives out;
  for (size_t k = 0; k < kDerivatives; ++k)
    out[k] = derivatives_[node][k] + t * (derivatives_[node + 1][k] - derivatives_[node][k]);
  return out;
}

}  // namespace jalon
