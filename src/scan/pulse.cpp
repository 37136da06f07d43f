// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/pulse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace jalon {

namespace {

using Recorded = StaticSettings::Echo;

constexpr double kBehindGlass_m = 1e-6;  // where the search goes on behind a pane
constexpr double kLeastCosine = 1e-6;    // of a sub-ray along a surface: it still counts
constexpr size_t kMostSubRays = 1 + 3 * size_t{kMostBeamRings} * (kMostBeamRings + 1);
constexpr size_t kRim = 6;  // sub-rays that tell whether the whole beam meets one plane

/// One sub-ray in the middle and 6, 12 ... on rings, each for the same area, at the root mean square radius of its
/// ring: the second moment of the disc is exact.
std::vector<Vec2> disc(int rings) {
  const int total = 1 + 3 * rings * (rings + 1);
  std::vector<Vec2> out{{0, 0}};
  for (int ring = rings; ring >= 1; --ring) {
    const int inside = 1 + 3 * ring * (ring - 1), count = 6 * ring;
    const double radius = std::sqrt((inside + 0.5 * count) / total);
    // The first six are every ring-th of the outermost ring.
    for (int start = 0; start < ring; ++start)
      for (int k = start; k < count; k += ring) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / count;
        out.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      }
  }
  return out;
}

}  // namespace

PulseCaster::PulseCaster(const StaticSettings& settings, const TriangleTree& tree,
                         const Surfaces& surfaces)
    : settings_(settings), tree_(tree), surfaces_(surfaces) {
  if (settings.has_beam()) offsets_ = disc(settings.beam_rings);
}

bool PulseCaster::hit(Ray ray, RandomStream random, RayHit& out) const {
  while (tree_.nearest(ray, out)) {
    const double returned = surfaces_.returned(out.triangle);
    if (returned >= 1 || random.uniform() < returned) return true;
    if (!surfaces_.lets_through(out.triangle)) return false;
    ray.t_min = out.t + kBehindGlass_m;
  }
  return false;
}

bool PulseCaster::sub_hit(const Vec3& eye, const Vec3& direction, size_t k,
                          const RandomStream& random, RayHit& out) const {
  const Vec3 across = normalized(std::abs(direction.z) < 0.9 ? cross(direction, Vec3{0, 0, 1})
                                                             : cross(direction, Vec3{1, 0, 0}));
  const Vec3 aside = across * offsets_[k].u + cross(direction, across) * offsets_[k].v;
  return hit({eye + aside * (settings_.beam_diameter_m / 2),
              normalized(direction + aside * std::tan(settings_.beam_divergence_rad / 2))},
             random, out);
}

bool PulseCaster::send(const Vec3& eye, const Vec3& direction, const RandomStream& random,
                       Echo& echo) const {
  // 1. The axis.
  RayHit axis;
  const bool is_hit = hit({eye, direction}, random, axis);
  echo = {axis.t, axis.triangle, false};
  if (offsets_.empty()) return is_hit;

  // 2. The rim: where all of the beam meets the same plane, or nothing, the axis says it all.
  std::array<RayHit, kMostSubRays> hits;
  size_t n = 0;
  if (is_hit) hits[n++] = axis;
  const uint32_t plane = is_hit ? surfaces_.segment(axis.triangle) : kNoSegment;
  bool is_whole = !is_hit || plane != kNoSegment;
  for (size_t k = 1; k <= kRim; ++k) {
    const bool found = sub_hit(eye, direction, k, random, hits[n]);
    is_whole =
        is_whole && found == is_hit && (!found || surfaces_.segment(hits[n].triangle) == plane);
    n += found;
  }
  if (is_whole) return is_hit;

  // 3. The rest of the beam, and what the instrument makes of it.
  for (size_t k = kRim + 1; k < offsets_.size(); ++k)
    n += sub_hit(eye, direction, k, random, hits[n]);
  if (n > 0) echo = merged({hits.data(), n}, direction);
  return n > 0;
}

Echo PulseCaster::merged(std::span<RayHit> hits, const Vec3& direction) const {
  // 1. Runs within the resolution of their nearest; the first, last or strongest is the return.
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    return a.t != b.t ? a.t < b.t : a.triangle < b.triangle;
  });
  std::array<double, kMostSubRays> weights;
  for (size_t i = 0; i < hits.size(); ++i)
    weights[i] = std::max(kLeastCosine, surfaces_.cosine(hits[i].triangle, direction));
  size_t from = 0, to = 0;
  double best = -1;
  for (size_t i = 0, j; i < hits.size(); i = j) {
    double weight = 0;
    for (j = i; j < hits.size() && hits[j].t - hits[i].t <= settings_.range_resolution_m; ++j)
      weight += weights[j];
    if (best < 0 || settings_.echo == Recorded::kLast ||
        (settings_.echo == Recorded::kStrongest && weight > best))
      from = i, to = j, best = weight;
  }
  // 2. Its weighted mean, relative to the nearest, and the face that gives most of it.
  double sum = 0, most = 0;
  Echo echo{0, hits[from].triangle, false};
  for (size_t i = from; i < to; ++i) {
    sum += weights[i] * (hits[i].t - hits[from].t);
    double of_face = 0;
    for (size_t j = from; j < to; ++j)
      if (surfaces_.face(hits[j].triangle) == surfaces_.face(hits[i].triangle))
        of_face += weights[j];
    if (of_face > most) most = of_face, echo.triangle = hits[i].triangle;
    echo.is_mixed |= surfaces_.segment(hits[i].triangle) != surfaces_.segment(hits[from].triangle);
  }
  echo.range = hits[from].t + sum / best;
  return echo;
}

}  // namespace jalon
