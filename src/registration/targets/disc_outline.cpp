// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/disc_outline.h"

#include <algorithm>
#include <cmath>

#include "geometry/cholesky.h"

namespace jalon {

namespace {

// Of the radius: a square of the disc's area has its sides 0.11 within its border and its corners 0.25 beyond.
constexpr double kRing = 0.28;
constexpr size_t kFirstHarmonic = 2, kHarmonics = 3;  // the first is the centre's, which is fitted
constexpr size_t kTerms = 1 + 2 * kHarmonics;
// Fourth harmonic of the outline of a square of the disc's area, of the radius:
// 8 / pi times the integral over 0 ... pi / 4 of cos(4 a) sqrt(pi) / (2 cos a), taken positive.
constexpr double kSquareWave = 0.139;
constexpr size_t kLeastRingPoints = 3 * kTerms;

Coefficients<kTerms> waves_at(const BrightPoint& p) {
  const double angle = std::atan2(p.v, p.u);
  Coefficients<kTerms> out{1};
  for (size_t k = 0; k < kHarmonics; ++k) {
    const double m = static_cast<double>(kFirstHarmonic + k);
    out[1 + 2 * k] = std::cos(m * angle), out[2 + 2 * k] = std::sin(m * angle);
  }
  return out;
}

}  // namespace

double chance_of_disc(std::span<const BrightPoint> points, const std::vector<double>& residuals,
                      double radius_m, double contrast) {
  Square<kTerms> normal{};
  Coefficients<kTerms> right{};
  double squares = 0;
  size_t n = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double off = std::hypot(points[i].u, points[i].v) / radius_m - 1;
    if (std::fabs(off) > kRing) continue;
    const auto j = waves_at(points[i]);
    for (size_t r = 0; r < kTerms; ++r) {
      right[r] += j[r] * residuals[i];
      for (size_t c = 0; c < kTerms; ++c) normal[kTerms * r + c] += j[r] * j[c];
    }
    squares += residuals[i] * residuals[i], ++n;
  }
  Cholesky<kTerms> factor;
  if (n < kLeastRingPoints || !factor.factor(normal)) return 0.5;
  const auto waves = factor.solve(right);
  for (size_t r = 0; r < kTerms; ++r) squares -= waves[r] * right[r];
  const double variance = std::max(0.0, squares) / static_cast<double>(n - kTerms);
  const auto inverse = factor.inverse();
  // A border that is off by d brightens or darkens d of the ring's 2 kRing by twice the contrast.
  const double to_radius = kRing / std::fabs(contrast);
  double least = 1;
  for (size_t k = 0; k < kHarmonics; ++k) {
    const size_t c = 1 + 2 * k, s = c + 1;
    const double wave = to_radius * std::hypot(waves[c], waves[s]);
    const double wave_variance = to_radius * to_radius * variance *
                                 (inverse[(kTerms + 1) * c] + inverse[(kTerms + 1) * s]) / 2;
    // Both likelihoods are normal: that of no wave and that of the square's.
    const double odds = kSquareWave * (kSquareWave / 2 - wave) / std::max(wave_variance, 1e-12);
    least = std::min(least, 1 / (1 + std::exp(-odds)));
  }
  return least;
}

}  // namespace jalon
