// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/feature_histogram.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kBins = 11;  // Rusu et al. 2009
constexpr float kSum = 100;   // of an angle's bins, as in the authors' own code
constexpr size_t kFeatureHistogramLeastNeighbours = 6;
constexpr size_t kSalientOneIn = 7;
constexpr size_t kFeatureHistogramGrain = 64;

size_t bin_of(double value, double low, double high) {
  const double at = (value - low) / (high - low) * static_cast<double>(kBins);
  return static_cast<size_t>(std::clamp(at, 0.0, static_cast<double>(kBins) - 1));
}

// The side of a point's surface that its neighbours lie on.
Vec3 facing_normal(const CoarseSurface& s, size_t i, const std::vector<Neighbour>& near) {
  double side = 0;
  for (const Neighbour& n : near) side += dot(s.points[n.index] - s.points[i], s.normals[i]);
  return side < 0 ? -s.normals[i] : s.normals[i];
}

// The simplified histogram of one point: the angles of the Darboux frame with each neighbour.
Feature simplified_histogram(const CoarseSurface& s, size_t i, double radius_m,
                             const std::vector<Neighbour>& near) {
  Feature out{};
  if (squared_norm(s.normals[i]) == 0 || near.size() < kFeatureHistogramLeastNeighbours) return out;
  const Vec3 u = facing_normal(s, i, near), place = s.points[i] + u * radius_m;
  size_t n = 0;
  for (const Neighbour& neighbour : near) {
    const size_t k = neighbour.index;
    if (k == i || squared_norm(s.normals[k]) == 0) continue;
    const Vec3 d = normalized(s.points[k] - s.points[i]);
    const Vec3 v = normalized(cross(d, u));
    if (squared_norm(v) == 0) continue;
    const Vec3 w = cross(u, v);
    const Vec3 normal = dot(place - s.points[k], s.normals[k]) < 0 ? -s.normals[k] : s.normals[k];
    ++out[bin_of(dot(v, normal), -1, 1)];
    ++out[kBins + bin_of(dot(u, d), -1, 1)];
    ++out[2 * kBins +
          bin_of(std::atan2(dot(w, normal), dot(u, normal)), -std::numbers::pi, std::numbers::pi)];
    ++n;
  }
  if (n == 0) return Feature{};
  for (float& bin : out) bin *= kSum / static_cast<float>(n);
  return out;
}

void normalise(Feature& f) {
  for (size_t angle = 0; angle < 3; ++angle) {
    float sum = 0;
    for (size_t b = 0; b < kBins; ++b) sum += f[angle * kBins + b];
    if (sum <= 0) continue;
    for (size_t b = 0; b < kBins; ++b) f[angle * kBins + b] *= kSum / sum;
  }
}

// Each point's own histogram and those of its neighbours, by their nearness.
std::vector<Feature> feature_histograms(const CoarseSurface& s, double radius_m, Task& task) {
  std::vector<Feature> simplified(s.size()), out(s.size());
  parallel_for(task, s.size(), kFeatureHistogramGrain, [&](size_t begin, size_t end) {
    std::vector<Neighbour> near;
    for (size_t i = begin; i < end; ++i) {
      s.tree->radius(s.points[i], radius_m, near);
      simplified[i] = simplified_histogram(s, i, radius_m, near);
    }
  });
  parallel_for(task, s.size(), kFeatureHistogramGrain, [&](size_t begin, size_t end) {
    std::vector<Neighbour> near;
    for (size_t i = begin; i < end; ++i) {
      Feature& f = out[i];
      if (simplified[i] == Feature{}) continue;
      s.tree->radius(s.points[i], radius_m, near);
      // Each neighbour's histogram by its nearness; the cell bounds the weight of those next door.
      double sum = 0;
      for (const Neighbour& n : near)
        if (n.index != i) sum += s.cell_m / std::max(std::sqrt(n.squared_distance), s.cell_m);
      for (const Neighbour& n : near) {
        if (n.index == i) continue;
        const double weight = s.cell_m / std::max(std::sqrt(n.squared_distance), s.cell_m) / sum;
        for (size_t b = 0; b < kFeatureSize; ++b)
          f[b] += static_cast<float>(weight) * simplified[n.index][b];
      }
      for (size_t b = 0; b < kFeatureSize; ++b) f[b] += simplified[i][b];
      normalise(f);
    }
  });
  return out;
}

void choose_distinct(CoarseSurface& s, size_t most) {
  std::array<double, kFeatureSize> sum{};
  s.distinct.clear();
  for (uint32_t i = 0; i < s.size(); ++i) {
    if (s.features[i] == Feature{}) continue;
    s.distinct.push_back(i);
    for (size_t k = 0; k < kFeatureSize; ++k) sum[k] += s.features[i][k];
  }
  const auto n = static_cast<double>(std::max<size_t>(1, s.distinct.size()));
  for (size_t k = 0; k < kFeatureSize; ++k) s.mean_feature[k] = static_cast<float>(sum[k] / n);
  std::vector<float> far(s.size());
  for (const uint32_t i : s.distinct) far[i] = squared_distance(s.features[i], s.mean_feature);
  std::sort(s.distinct.begin(), s.distinct.end(),
            [&](uint32_t a, uint32_t b) { return far[a] != far[b] ? far[a] > far[b] : a < b; });
  const auto farthest = [&s](size_t count) {
    std::vector<uint32_t> out(s.distinct);
    out.resize(std::min(count, out.size()));
    std::sort(out.begin(), out.end());
    return out;
  };
  s.salient = farthest(s.size() / kSalientOneIn);
  s.distinct = farthest(most);
}

}  // namespace

float squared_distance(const Feature& a, const Feature& b) {
  float sum = 0;
  for (size_t k = 0; k < kFeatureSize; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

void describe_features(CoarseSurface& surface, double radius_m, size_t most, Task& task) {
  surface.features = feature_histograms(surface, radius_m, task);
  choose_distinct(surface, most);
}

}  // namespace jalon
