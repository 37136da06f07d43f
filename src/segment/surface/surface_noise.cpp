// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/surface_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "geometry/plane.h"
#include "geometry/symmetric_eigen.h"

namespace jalon {

namespace {

constexpr size_t kNoiseSamples = 1024;  // the quartile of a quarter of them is right to 10 %
constexpr size_t kNoiseSamplesPerChunk = 32;
constexpr std::array<uint32_t, 4> kNoiseNeighbours = {32, 128, 512, 2048};
// A neighbourhood is a surface where it is so many times as wide as thick (both as standard deviations): then the noise
// turns its plane by less than 1 % of it; the widest ones may be narrower, and the noise is 6 % too small at 3.
constexpr double kSurfaceWidths = 8, kLeastSurfaceWidths = 3;
constexpr double kLeastKindShare = 0.1;  // of the neighbourhoods, for a kind to count
constexpr double kLeastFlatShare =
    0.05;  // of smaller ones, that show it to be shape: 7 % of insa with 20 mm of noise
// Neighbourhoods this small lie within panels and bays that are four points wide.
constexpr uint32_t kLeastNoiseNeighbours = 12;
// Cosine of 30 degrees: a profile alone is a thin plane of its own, across the surface that it was drawn on.
constexpr double kFacesAlike = 0.866;
// Noise of one kind of surfaces differs by less, with distance and material; shape by tens.
constexpr double kSameNoise = 3;
constexpr double kUpright = 0.5;  // largest |z| of the normal: within 30 degrees of the vertical

/// The value below which this share lies.
double value_at(std::vector<double> values, double share) {
  const double rank = share * static_cast<double>(values.size());
  const auto at = values.begin() + static_cast<ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Of chi-square / dof, which a neighbourhood's variance is about the true one (Wilson & Hilferty 1931).
double quartile_of_variances(double dof) {
  constexpr double kNormalQuartile = 0.6745;
  const double variance = 2 / (9 * std::max(dof, 1.0));
  const double root = 1 - variance - kNormalQuartile * std::sqrt(variance);
  return root * root * root;
}

/// The noise of one kind of surfaces, where neighbourhoods of this size show it; 0: there are hardly any.
std::optional<double> noise_of_kind(const std::vector<Spread>& all, size_t neighbours, bool upright,
                                    double widths) {
  std::vector<double> across, along;
  for (const Spread& spread : all) {
    if (spread.upright != upright) continue;
    across.push_back(spread.across);
    along.push_back(spread.along);
  }
  if (across.empty() ||
      static_cast<double>(across.size()) < kLeastKindShare * static_cast<double>(all.size()))
    return 0.0;
  const double variance = value_at(std::move(across), 0.25) /
                          quartile_of_variances(static_cast<double>(neighbours) - 3);
  if (value_at(std::move(along), 0.5) < widths * widths * variance) return std::nullopt;
  return std::sqrt(variance);
}

/// The surfaces among small neighbourhoods that face as the wide ones about the same points, of one kind, do.
struct FlatWithin {
  double share = 0;  ///< of that kind
  double sigma_m = 0;
};
FlatWithin flat_within(const std::vector<Spread>& small, const std::vector<Spread>& wide,
                       bool upright) {
  double of_kind = 0;
  std::vector<double> across;
  for (size_t i = 0; i < small.size(); ++i) {
    if (wide[i].upright != upright) continue;
    ++of_kind;
    if (small[i].along >= kSurfaceWidths * kSurfaceWidths * small[i].across &&
        std::fabs(dot(small[i].normal, wide[i].normal)) >= kFacesAlike)
      across.push_back(small[i].across);
  }
  if (across.empty()) return {};
  const double share = static_cast<double>(across.size()) / of_kind;
  return {share, std::sqrt(value_at(std::move(across), 0.5))};
}

/// Noise, or that of the smaller neighbourhoods most of which are surfaces, where they show it to be shape.
double without_shape(double noise_m, const std::vector<std::vector<Spread>>& smaller,
                     const std::vector<Spread>& wide, bool upright) {
  FlatWithin most;
  for (const std::vector<Spread>& small : smaller) {
    const FlatWithin flat = flat_within(small, wide, upright);
    if (flat.share > most.share) most = flat;
  }
  const bool is_shape = most.share >= kLeastFlatShare && noise_m > kSameNoise * most.sigma_m;
  return is_shape ? most.sigma_m : noise_m;
}

}  // namespace

std::vector<Spread> neighbourhood_spreads(const Cloud& cloud, const Octree& tree, uint32_t k,
                                          size_t samples, Task& task) {
  std::vector<Spread> out(std::min(samples, tree.size()));
  parallel_for(task, out.size(), kNoiseSamplesPerChunk, [&](size_t begin, size_t end) {
    std::vector<Neighbour> near(k);
    for (size_t i = begin; i < end; ++i) {
      const Vec3 query = cloud.point(tree.order()[i * tree.size() / out.size()]);
      const size_t found = tree.knn(query, k, near);
      Moments moments;
      moments.reference = query;
      for (size_t j = 0; j < found; ++j) moments.add(cloud.point(near[j].index));
      const Eigen3 eigen = symmetric_eigen(moments.covariance());
      // covariance() divides by n; least squares leaves n - 3 degrees of freedom.
      const double n = static_cast<double>(found);
      const Vec3& normal = eigen.vectors[0];
      out[i] = {found > 3 ? std::max(0.0, eigen.values[0]) * n / (n - 3) : 0,
                std::max(0.0, eigen.values[1]), std::fabs(normal.z) < kUpright, normal};
    }
  });
  return out;
}

double surface_noise_m(const Cloud& cloud, const Octree& tree, Task& task) {
  std::array<std::optional<double>, 2> noise;
  std::vector<std::vector<Spread>> smaller{
      neighbourhood_spreads(cloud, tree, kLeastNoiseNeighbours, kNoiseSamples, task)};
  for (const uint32_t k : kNoiseNeighbours) {
    std::vector<Spread> all = neighbourhood_spreads(cloud, tree, k, kNoiseSamples, task);
    const bool last = k == kNoiseNeighbours.back() || k >= tree.size();
    for (const bool upright : {false, true}) {
      if (noise[upright]) continue;
      noise[upright] = noise_of_kind(all, std::min<size_t>(k, tree.size()), upright,
                                     last ? kLeastSurfaceWidths : kSurfaceWidths);
      if (noise[upright]) noise[upright] = without_shape(*noise[upright], smaller, all, upright);
    }
    if (last || (noise[0] && noise[1])) break;
    smaller.push_back(std::move(all));
  }
  return std::max(noise[0].value_or(0), noise[1].value_or(0));
}

}  // namespace jalon
