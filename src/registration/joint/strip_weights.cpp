// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_weights.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// 95 % as good as the mean where the scatter is normal.
constexpr double kTukeyWidth = 4.685, kMadToSigma = 1.4826;

void weigh_strip(const std::vector<uint32_t>& points, const std::vector<PointMatch>& matches,
                 double noise_m, std::vector<double>& weights) {
  std::vector<double> values;
  for (const uint32_t i : points) values.push_back(matches[i].distance_m);
  const double median = median_of(values);
  for (size_t k = 0; k < points.size(); ++k)
    values[k] = std::fabs(matches[points[k]].distance_m - median);
  const double scale = std::max(noise_m, kMadToSigma * median_of(values));
  for (const uint32_t i : points) {
    const double r = (matches[i].distance_m - median) / (kTukeyWidth * scale);
    weights[i] = std::fabs(r) < 1 ? (1 - r * r) * (1 - r * r) : 0;
  }
}

}  // namespace

std::vector<double> strip_weights(const std::vector<PointMatch>& matches, size_t strips,
                                  const JointSettings& settings) {
  std::vector<double> weights(matches.size(), 0);
  std::vector<std::vector<uint32_t>> of_strip(strips);
  for (uint32_t i = 0; i < matches.size(); ++i) {
    if (matches[i].state != MatchState::kMatched) continue;
    weights[i] = 1;
    of_strip[matches[i].strip].push_back(i);
  }
  if (settings.kernel == JointSettings::Kernel::kNone ||
      settings.matches == JointSettings::Matches::kIds)
    return weights;
  // The scatter of exact points is 0: a least one keeps rounding from deciding.
  constexpr double kLeastNoise_m = 1e-6;
  for (const auto& points : of_strip)
    if (!points.empty())
      weigh_strip(points, matches, std::max(kLeastNoise_m, settings.sigma_point_m), weights);
  return weights;
}

}  // namespace jalon
