// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/facade_strips.h"

#include <cmath>

#include "base/error.h"

namespace jalon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

void correlate(const JointProblem& problem, FacadeStrips& f) {
  const auto n = static_cast<Index>(f.strips.size());
  if (n == 0) return;
  const double strip_m2 = problem.sigma_strip_m * problem.sigma_strip_m;
  f.prior.resize(n, n);
  MatrixXd V(n, n);
  const double facade_m2 = problem.facade_variance_m2(problem.strips[f.strips[0]].facade);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const StripCondition &a = problem.strips[f.strips[static_cast<size_t>(i)]],
                           &b = problem.strips[f.strips[static_cast<size_t>(j)]];
      f.prior(i, j) = strip_m2 * strip_correlation(problem, a, b);
      V(i, j) = f.prior(i, j) + facade_m2 + (i == j ? a.measured_variance_m2 : 0);
    }
  const Eigen::LDLT<MatrixXd> factor(V);
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0))
    fail(Status::kDegenerate, "two strips of a facade stand in one place: they are one");
  f.inverse.resize(n, n);
  for (Index j = 0; j < n; ++j) f.inverse.col(j) = factor.solve(Eigen::VectorXd::Unit(n, j));
}

}  // namespace

double strip_correlation(const JointProblem& problem, const StripCondition& a,
                         const StripCondition& b) {
  return std::exp(-std::fabs(a.place_m - b.place_m) / problem.strip_correlation_m);
}

std::vector<double> FacadeStrips::weighted(const std::vector<double>& y) const {
  std::vector<double> out(y.size());
  if (is_correlated()) {
    for (size_t i = 0; i < y.size(); ++i) {
      double row = 0;
      for (size_t j = 0; j < y.size(); ++j)
        row += inverse(static_cast<Index>(i), static_cast<Index>(j)) * y[j];
      out[i] = row;
    }
    return out;
  }
  double total = 0;
  for (size_t i = 0; i < y.size(); ++i) total += inverse_d[i] * y[i];
  for (size_t i = 0; i < y.size(); ++i) out[i] = inverse_d[i] * (y[i] - weight * total);
  return out;
}

std::vector<FacadeStrips> strips_by_facade(const JointProblem& problem) {
  std::vector<FacadeStrips> made(problem.facades);
  for (uint32_t s = 0; s < problem.strips.size(); ++s) {
    FacadeStrips& f = made[problem.strips[s].facade];
    f.strips.push_back(s);
    f.inverse_d.push_back(1 / (problem.sigma_strip_m * problem.sigma_strip_m +
                               problem.strips[s].measured_variance_m2));
    f.sum += f.inverse_d.back();
  }
  for (uint32_t i = 0; i < problem.facades; ++i) {
    FacadeStrips& f = made[i];
    const double variance = problem.facade_variance_m2(i);
    f.weight = variance / (1 + variance * f.sum);
    if (problem.strip_correlation_m > 0) correlate(problem, f);
  }
  return made;
}

}  // namespace jalon
