// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_conditions.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>

#include "model/trajectory/interpolation.h"

namespace jalon {

namespace {

struct StripSums {
  uint64_t points = 0;
  double weight = 0, weight2 = 0, distance_m = 0;
  std::map<uint32_t, double> shares;
  std::array<double, 3> turns_m{};
};

}  // namespace

StripConditions strip_conditions(const MatchedPoints& points, std::span<const GivenStrip> strips,
                                 std::span<const double> control_times_s, uint64_t least_points,
                                 double sigma_range_m) {
  std::vector<StripSums> sums(strips.size());
  size_t hint = 0;
  for (size_t i = 0; i < points.strips.size(); ++i) {
    const double time = points.times_s[i], weight = points.weights.empty() ? 1 : points.weights[i];
    if (points.strips[i] >= strips.size() || !(weight > 0) || time < control_times_s.front() ||
        time > control_times_s.back())
      continue;
    const TimePlace at = time_place(control_times_s, time, i, hint);
    hint = at.epoch;
    const GivenStrip& strip = strips[points.strips[i]];
    StripSums& sum = sums[points.strips[i]];
    ++sum.points;
    sum.weight += weight;
    sum.weight2 += weight * weight;
    // (Q - P) . n: how far the plane is in front of the point.
    sum.distance_m += weight * (strip.offset_m - strip.normal.u * points.xyz[3 * i] -
                                strip.normal.v * points.xyz[3 * i + 1]);
    for (size_t k = 0; k < 3 && !points.turns.empty(); ++k)
      sum.turns_m[k] -= weight * dot(strip.normal, points.turns[i][k]);
    sum.shares[static_cast<uint32_t>(at.epoch)] += weight * (1 - at.share);
    sum.shares[static_cast<uint32_t>(at.epoch + 1)] += weight * at.share;
  }
  StripConditions made;
  for (uint32_t s = 0; s < strips.size(); ++s) {
    const StripSums& sum = sums[s];
    if (sum.points == 0 || sum.points < least_points) continue;
    const double n = sum.weight;
    StripCondition condition{
        strips[s].block,    strips[s].facade,
        strips[s].normal,   {},
        sum.distance_m / n, sigma_range_m * sigma_range_m * sum.weight2 / (n * n),
        strips[s].place_m,  {}};
    for (size_t k = 0; k < 3; ++k) condition.turns_m[k] = sum.turns_m[k] / n;
    for (const auto& [control, share] : sum.shares)
      if (share > 0) condition.shares.push_back({control, share / n});
    made.conditions.push_back(std::move(condition));
    made.strip_of.push_back(s);
    made.points.push_back(sum.points);
  }
  return made;
}

WeakDirection weak_direction(std::span<const StripCondition> strips) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  for (const StripCondition& s : strips) {
    const Eigen::Vector2d n(s.normal.u, s.normal.v);
    sum += n * n.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> of(sum);
  return {{of.eigenvectors()(0, 0), of.eigenvectors()(1, 0)},
          std::max(0.0, of.eigenvalues()[0]) / of.eigenvalues()[1]};
}

}  // namespace jalon
