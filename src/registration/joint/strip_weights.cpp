// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_weights.h"

#include <algorithm>
#include <cmath>

#include "registration/joint/strip_surfaces.h"

namespace jalon {

namespace {

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// 95 % as good as the mean where the scatter is normal.
constexpr double kTukeyWidth = 4.685, kMadToSigma = 1.4826;

MetPoint seen_from(const JointPoints& points, const StripScene& scene, const PointMatch& match,
                   uint32_t number) {
  const Vec2& normal = scene.strips[match.strip].normal;
  const Vec3& way = points.direction[number];
  return {number, match.distance_m, points.at[number].z,
          way.z / std::fabs(normal.u * way.x + normal.v * way.y),
          match.state == MatchState::kMatched};
}

// All points that met the strip, by the ones that stand on its wall.
void weigh_strip(const std::vector<MetPoint>& met, double noise_m, std::vector<double>& weights) {
  const std::vector<MetPoint> wall = points_of_wall(met);
  if (wall.empty()) return;
  std::vector<double> values;
  for (const MetPoint& p : wall) values.push_back(p.distance_m);
  const double median = median_of(values);
  for (size_t k = 0; k < wall.size(); ++k) values[k] = std::fabs(wall[k].distance_m - median);
  const double scale = std::max(noise_m, kMadToSigma * median_of(values));
  for (const MetPoint& p : wall) {
    const double r = (p.distance_m - median) / (kTukeyWidth * scale);
    weights[p.number] = std::fabs(r) < 1 ? (1 - r * r) * (1 - r * r) : 0;
  }
}

}  // namespace

std::vector<double> strip_weights(const JointPoints& points, const StripScene& scene,
                                  const std::vector<PointMatch>& matches,
                                  const JointSettings& settings) {
  std::vector<double> weights(matches.size(), 0);
  if (settings.kernel == JointSettings::Kernel::kNone ||
      settings.matches == JointSettings::Matches::kIds) {
    for (size_t i = 0; i < matches.size(); ++i)
      weights[i] = matches[i].state == MatchState::kMatched ? 1 : 0;
    return weights;
  }
  std::vector<std::vector<MetPoint>> of_strip(scene.strips.size());
  for (uint32_t i = 0; i < matches.size(); ++i) {
    const PointMatch& m = matches[i];
    if (m.state == MatchState::kMatched || (m.state == MatchState::kFar && m.distance_m < 0))
      of_strip[m.strip].push_back(seen_from(points, scene, m, i));
  }
  // The scatter of exact points is 0: a least one keeps rounding from deciding.
  constexpr double kLeastNoise_m = 1e-6;
  for (const auto& met : of_strip)
    if (!met.empty()) weigh_strip(met, std::max(kLeastNoise_m, settings.sigma_point_m), weights);
  return weights;
}

}  // namespace jalon
