// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/tolerance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/distributions.h"
#include "segment/surface/surface_noise.h"

namespace jalon {

namespace {

constexpr size_t kSamples =
    8192;  // the median of a scene with half its points on planes is right to 2 %
constexpr uint32_t kLeastNeighbours = 32, kMostNeighbours = 256;
// The neighbourhood's rms width against the noise: at 8, the plane follows the noise by 1 / (2 x 8^2), under 1 %.
constexpr double kWidths = 8;
// The ranges of the parameters: noise-free clouds have no sigma.
constexpr double kLeastSigma_m = 1e-6, kLeastTolerance_m = 1e-5, kMostTolerance_m = 10;

/// Variances across and along the narrow side of the neighbourhoods, medians over the sample.
struct LocalSpread {
  double across = 0, along = 0;
};

/// A neighbourhood's variance is chi-square / dof about the true one, and the median of that lies below 1: (1 - 2 / (9
/// dof))^3 (Wilson & Hilferty 1931).
double median_of_variances(double dof) {
  const double root = 1 - 2 / (9 * dof);
  return root * root * root;
}

double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

LocalSpread local_spread(const Cloud& cloud, const Octree& tree, uint32_t k, Task& task) {
  std::vector<double> across, along;
  for (const Spread& spread : neighbourhood_spreads(cloud, tree, k, kSamples, task)) {
    across.push_back(spread.across);
    along.push_back(spread.along);
  }
  const double dof = static_cast<double>(std::min<size_t>(k, tree.size())) - 3;
  return {median(across) / (dof > 0 ? median_of_variances(dof) : 1), median(along)};
}

// A plane's half-thickness in sigmas of its points, as the parameter's help says: 99.7 % of them.
constexpr double kSigmasOfTolerance = 3;
constexpr double kMostNoise_m =
    0.25;  // ten times the default tolerance; more is another unit (3 mm taken for 3 m)

/// The default, or what noise needs that is more than the default was chosen for (scanners on vehicles, in the hand).
Tolerance no_less_than_noise(const Cloud& cloud, const Octree& tree, const RansacSettings& settings,
                             Task& task) {
  const Tolerance plain{settings.surface.distance_tolerance_m, settings.tolerance.sigma_m};
  if (plain.distance_tolerance_m != SurfaceSettings{}.distance_tolerance_m) return plain;
  const double noise = surface_noise_m(cloud, tree, task);
  const double tolerance = kSigmasOfTolerance * noise;
  if (tolerance <= plain.distance_tolerance_m || noise > kMostNoise_m) return plain;
  return {tolerance, noise};
}

}  // namespace

double tolerance_of_sigma(double sigma_m, double probability, int dof) {
  return std::sqrt(chi_square_quantile(dof, probability)) * sigma_m;
}

double estimate_sigma(const Cloud& cloud, const Octree& tree, Task& task) {
  LocalSpread spread;
  for (uint32_t k = kLeastNeighbours; k <= kMostNeighbours; k *= 2) {
    spread = local_spread(cloud, tree, k, task);
    if (spread.along >= kWidths * kWidths * spread.across || k >= tree.size()) break;
  }
  return std::sqrt(spread.across);
}

Tolerance tolerance_of(const Cloud& cloud, const Octree& tree, const RansacSettings& settings,
                       Task& task) {
  const ToleranceSettings& from = settings.tolerance;
  if (from.tolerance_from == ToleranceSource::kAuto)
    return no_less_than_noise(cloud, tree, settings, task);
  if (from.tolerance_from == ToleranceSource::kHand)
    return {settings.surface.distance_tolerance_m, from.sigma_m};
  Tolerance out{0, from.sigma_m};
  if (from.tolerance_from == ToleranceSource::kEstimate)
    out.sigma_m = std::clamp(estimate_sigma(cloud, tree, task), kLeastSigma_m, kMostTolerance_m);
  const double tolerance =
      tolerance_of_sigma(out.sigma_m, from.tolerance_probability, from.tolerance_dof);
  out.distance_tolerance_m = std::clamp(tolerance, kLeastTolerance_m, kMostTolerance_m);
  return out;
}

}  // namespace jalon
