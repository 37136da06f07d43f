// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/surface/face_plane.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr size_t kFacePlaneMost = 32;  // neighbours looked at
constexpr size_t kHypotheses =
    6;  // nearest points that, two at a time, give the planes: fifteen of them
constexpr size_t kFacePlaneLeastPoints = 6;
// A plane through three noisy points is off by some noises where it is extrapolated; one through all is not.
constexpr double kWide = 4;
// Points along a line fix no plane: the narrower extent must be a fifth of the wider.
constexpr double kFacePlaneLeastAspect = 0.04;

using Four = float __attribute__((vector_size(16)));
constexpr size_t kLanes = 4;

/// The neighbours relative to the point, in grid steps.
struct Around {
  alignas(16) float x[kFacePlaneMost], y[kFacePlaneMost], z[kFacePlaneMost];
  size_t count = 0;
  Vec3 at(size_t i) const { return {x[i], y[i], z[i]}; }
};

Around around(const Octree& tree, size_t position, std::span<const uint32_t> neighbours) {
  Around out;
  out.count = std::min(neighbours.size(), kFacePlaneMost);
  const int32_t *x = tree.grid_x(), *y = tree.grid_y(), *z = tree.grid_z();
  for (size_t i = 0; i < out.count; ++i) {
    out.x[i] = static_cast<float>(x[neighbours[i]] - x[position]);
    out.y[i] = static_cast<float>(y[neighbours[i]] - y[position]);
    out.z[i] = static_cast<float>(z[neighbours[i]] - z[position]);
  }
  for (size_t i = out.count; i < (out.count + kLanes - 1) / kLanes * kLanes; ++i)
    out.x[i] = out.y[i] = out.z[i] = HUGE_VALF;  // on no plane
  return out;
}

// Sum of 1 - (d / limit)^2 over the points within the limit of the plane through the point.
float score_of(const Around& points, const Vec3& normal, float limit) {
  const float inverse = 1 / limit;
  const auto nx = static_cast<float>(normal.x) * inverse,
             ny = static_cast<float>(normal.y) * inverse,
             nz = static_cast<float>(normal.z) * inverse;
  Four sum{};
  for (size_t i = 0; i < points.count; i += kLanes) {
    const Four x = *reinterpret_cast<const Four*>(points.x + i),
               y = *reinterpret_cast<const Four*>(points.y + i),
               z = *reinterpret_cast<const Four*>(points.z + i);
    const Four d = x * nx + y * ny + z * nz, left = 1 - d * d;
    sum += left > 0 ? left : Four{};
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

// Step 1: the normal; none where the nearest points lie on a line.
std::optional<Vec3> best_normal(const Around& points, double noise) {
  std::optional<Vec3> normal;
  const auto limit = static_cast<float>(kWide * noise);
  const size_t used = std::min(points.count, kHypotheses + 1);
  float best = 0;
  for (size_t i = 0; i < used; ++i)
    for (size_t j = i + 1; j < used; ++j) {
      const Vec3 n = cross(points.at(i), points.at(j));
      const double length2 = squared_norm(n);
      // The point itself, and points in line with it, span no plane.
      if (!(length2 >
            kFacePlaneLeastAspect * squared_norm(points.at(i)) * squared_norm(points.at(j))))
        continue;
      const Vec3 unit = n / std::sqrt(length2);
      const float score = score_of(points, unit, limit);
      if (score <= best) continue;
      best = score;
      normal = unit;
    }
  return normal;
}

// Step 2: sums of the points within the limit of a plane.
PlanePoints sums_within(const Around& points, const Vec3& normal, double offset, double limit) {
  PlanePoints out;
  Vec3 sum;
  Symmetric3 products{};
  for (size_t i = 0; i < points.count; ++i) {
    const Vec3 p = points.at(i);
    if (!(std::abs(dot(normal, p) - offset) <= limit)) continue;
    ++out.count;
    sum += p;
    const double row[6] = {p.x * p.x, p.x * p.y, p.x * p.z, p.y * p.y, p.y * p.z, p.z * p.z};
    for (size_t k = 0; k < 6; ++k) products[k] += row[k];
  }
  if (out.count == 0) return out;
  const double inverse = 1 / static_cast<double>(out.count);
  out.offset = sum * inverse;
  const double mean[6] = {sum.x * sum.x, sum.x * sum.y, sum.x * sum.z,
                          sum.y * sum.y, sum.y * sum.z, sum.z * sum.z};
  for (size_t k = 0; k < 6; ++k) out.scatter[k] = products[k] - mean[k] * inverse;
  return out;
}

}  // namespace

std::optional<PlanePoints> points_of_face(const Octree& tree, size_t position,
                                          std::span<const uint32_t> neighbours, double noise) {
  const Around points = around(tree, position, neighbours);
  const std::optional<Vec3> normal = best_normal(points, noise);
  if (!normal) return std::nullopt;
  PlanePoints out = sums_within(points, *normal, 0, kWide * noise);
  constexpr int kRefits = 2;
  for (int refit = 0; refit < kRefits; ++refit) {
    if (out.count < kFacePlaneLeastPoints) return std::nullopt;
    const Eigen3 e = symmetric_eigen(out.scatter);
    if (!(e.values[1] > kFacePlaneLeastAspect * e.values[2])) return std::nullopt;
    const double offset = dot(e.vectors[0], out.offset);
    if (std::abs(offset) > kFaceNoises * noise) return std::nullopt;  // the point is not on it
    out = sums_within(points, e.vectors[0], offset, kFaceNoises * noise);
  }
  if (out.count < kFacePlaneLeastPoints) return std::nullopt;
  return out;
}

}  // namespace jalon
