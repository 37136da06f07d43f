// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/growing/flatness.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "geometry/quadric.h"

namespace jalon {

namespace {

constexpr uint64_t kLeastSeedPoints = 12;  // fewer say little of a sigma (as in local_surface.cpp)
constexpr uint64_t kLeastOwnPoints = 5;    // of the leaf: at least two more than any plane fits
constexpr double kMaxThickness = 0.5;      // sigma of a seed, in tolerances
constexpr double kMaxFlatness = 0.05;      // smallest against middle eigenvalue of a seed
constexpr size_t kMaxSample = 2000;  // fixes the curvature of a piece of a column to a few percent
constexpr double kLargestTurn_rad = 0.35;
constexpr size_t kFlatnessLeavesPerChunk = 512;

}  // namespace

bool seed_plane(const SegmentScene& scene, const GrowingPoints& points, size_t leaf,
                PlaneFit& fit) {
  if (points.leaf_spacing[leaf] < 0) return false;
  const double tolerance = scene.settings.distance_tolerance_m, cosine = scene.min_cosine();
  const auto first = points.leaf_first();
  Moments moments;
  moments.reference = points.tree->local(first[leaf]);
  const Plane* plane = nullptr;
  const auto add = [&](size_t l) {
    for (size_t i = first[l]; i < first[l + 1]; ++i) {
      const uint32_t position = points.position(i);
      if (points.isolated[i] != 0 || scene.owner[position] != 0) continue;
      const Vec3 p = points.tree->local(i);
      if (plane != nullptr && (std::fabs(plane->distance(p)) > tolerance ||
                               scene.inconsistent(position, plane->normal, cosine)))
        continue;
      moments.add(p);
    }
  };
  const auto flat = [&] {
    return fit_plane(moments, fit) && fit.sigma <= kMaxThickness * tolerance &&
           fit.eigenvalues[0] <= kMaxFlatness * fit.eigenvalues[1];
  };
  add(leaf);
  if (moments.n < kLeastOwnPoints || !flat()) return false;
  // The leaf alone is flat: its neighbours count as far as they lie in its plane, else no surface narrower than three
  // leaves would have a seed.
  const Plane own = fit.plane;
  plane = &own;
  for (const uint32_t near : points.graph.of(leaf)) add(near);
  return moments.n >= kLeastSeedPoints && flat();
}

std::vector<uint32_t> seeds_by_flatness(const SegmentScene& scene, const GrowingPoints& points,
                                        Task& task) {
  const size_t leaves = points.leaves();
  std::vector<float> sigma(leaves, INFINITY);
  parallel_for(task, leaves, kFlatnessLeavesPerChunk, [&](size_t begin, size_t end) {
    PlaneFit fit;
    for (size_t leaf = begin; leaf < end; ++leaf)
      if (seed_plane(scene, points, leaf, fit)) sigma[leaf] = static_cast<float>(fit.sigma);
  });
  std::vector<uint32_t> seeds;
  for (size_t leaf = 0; leaf < leaves; ++leaf)
    if (sigma[leaf] < INFINITY) seeds.push_back(static_cast<uint32_t>(leaf));
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](uint32_t a, uint32_t b) { return sigma[a] < sigma[b]; });
  return seeds;
}

bool is_bent(const PlaneFit& fit, const GrowingPoints& points,
             const std::vector<uint32_t>& members) {
  const size_t step = (members.size() + kMaxSample - 1) / kMaxSample;
  std::vector<Vec3> sample;
  double u = 0, v = 0;  // half extents
  for (size_t i = 0; i < members.size(); i += step) {
    const Vec3 d = points.tree->local(members[i]) - fit.centroid;
    sample.push_back({dot(d, fit.axis_u), dot(d, fit.axis_v), dot(d, fit.plane.normal)});
    u = std::max(u, std::fabs(sample.back().x));
    v = std::max(v, std::fabs(sample.back().y));
  }
  Quadric q;
  if (!fit_quadric(sample, std::max(u, v), q)) return false;
  // Slopes at the ends less those at the other ends: 2 a times the length, and so on.
  return std::max({4 * std::fabs(q.a) * u, 4 * std::fabs(q.e) * v,
                   2 * std::fabs(q.c) * std::max(u, v)}) > kLargestTurn_rad;
}

}  // namespace jalon
