// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/common_misfit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/cholesky.h"

namespace jalon {

namespace {

constexpr size_t kUnknowns = 6;
constexpr size_t kLeastSurfaces = 10 * kUnknowns;
constexpr int kReweightings = 60;
// In sigmas: below, a deviation weighs as this one does, so that none holds the motion alone.
constexpr double kLeastDeviation = 0.1;
constexpr double kSettledShare =
    1e-5;                          // of the sum of deviations, from one reweighting to the next
constexpr double kUnfixed = 1e-9;  // of the largest weight: directions that nothing fixes stay
constexpr double kLeastSigma_m = 1e-9;
// Sparsity of the standard normal at its median, sqrt(2 pi); the ratio is 4 (sum - sum_with) / sparsity.
constexpr double kSparsity = 2.5066282746310002;
constexpr double kChiSquare6 = 22.46;  // 99.9 % with six degrees of freedom
constexpr double kOverlap = 2;         // surfaces that each point belongs to: so many are one

struct Equation {
  Coefficients<kUnknowns> j;  ///< of shift and turn, lengths in sizes of the scene, over sigma
  double offset;              ///< over sigma
};

double deviation(const Equation& e, const Coefficients<kUnknowns>& x) {
  double sum = e.offset;
  for (size_t k = 0; k < kUnknowns; ++k) sum -= e.j[k] * x[k];
  return std::abs(sum);
}

double sum_of(std::span<const Equation> equations, const Coefficients<kUnknowns>& x) {
  double sum = 0;
  for (const Equation& e : equations) sum += deviation(e, x);
  return sum;
}

// Least squares with weights by the deviations that it left before.
bool reweighted(std::span<const Equation> equations, Coefficients<kUnknowns>& x) {
  Square<kUnknowns> normal{};
  Coefficients<kUnknowns> right{};
  for (const Equation& e : equations) {
    const double weight = 1 / std::max(deviation(e, x), kLeastDeviation);
    for (size_t r = 0; r < kUnknowns; ++r) {
      right[r] += weight * e.offset * e.j[r];
      for (size_t c = 0; c < kUnknowns; ++c) normal[kUnknowns * r + c] += weight * e.j[r] * e.j[c];
    }
  }
  double most = 0;
  for (size_t k = 0; k < kUnknowns; ++k) most = std::max(most, normal[(kUnknowns + 1) * k]);
  for (size_t k = 0; k < kUnknowns; ++k) normal[(kUnknowns + 1) * k] += kUnfixed * most;
  Cholesky<kUnknowns> factor;
  if (!factor.factor(normal)) return false;
  x = factor.solve(right);
  return true;
}

}  // namespace

CommonMisfit common_misfit(std::span<const SurfaceOffset> surfaces, Task& task) {
  CommonMisfit out;
  if (surfaces.size() < kLeastSurfaces) return out;
  for (const SurfaceOffset& s : surfaces) out.about += s.place;
  out.about = out.about / static_cast<double>(surfaces.size());
  double size_m = 0;
  for (const SurfaceOffset& s : surfaces) size_m = std::max(size_m, norm(s.place - out.about));
  if (!(size_m > 0)) return out;
  std::vector<Equation> equations;
  for (const SurfaceOffset& s : surfaces) {
    const double sigma = std::max(s.sigma_m, kLeastSigma_m);
    const Vec3 turn = cross((s.place - out.about) / size_m, s.normal);
    Equation& e = equations.emplace_back();
    e.offset = s.offset_m / sigma;
    for (int c = 0; c < 3; ++c) {
      e.j[static_cast<size_t>(c)] = s.normal[c] / sigma;
      e.j[static_cast<size_t>(c) + 3] = turn[c] / sigma;
    }
  }
  Coefficients<kUnknowns> x{};
  const double without = sum_of(equations, x);
  double with = without;
  for (int k = 0; k < kReweightings; ++k) {
    task.checkpoint(0);
    if (!reweighted(equations, x)) return out;
    const double before = with;
    with = sum_of(equations, x);
    if (k > 0 && std::abs(before - with) <= kSettledShare * before) break;
  }
  if (!(4 * (without - with) / kSparsity > kOverlap * kChiSquare6)) return out;
  out.shift_m = {x[0], x[1], x[2]};
  out.turn_rad = Vec3{x[3], x[4], x[5]} / size_m;
  return out;
}

}  // namespace jalon
