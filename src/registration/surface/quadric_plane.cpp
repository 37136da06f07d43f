// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/surface/quadric_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/symmetric_eigen.h"

namespace jalon {

namespace {

constexpr size_t kQuadricPlaneUnknowns = 6;
constexpr size_t kQuadricPlaneMost = 64;  // neighbours looked at
constexpr size_t kLeast = 2 * kQuadricPlaneUnknowns;
constexpr double kQuadricPlaneLeastAspect =
    0.1;  // of the neighbours' spread, squared: a strip fixes no bend across itself
constexpr double kSteepest =
    1.25;  // slope of the paraboloid at the point: the neighbours' plane is no base for it

// Step 2: the plane through the neighbours as base; none where they lie along a line.
std::optional<TangentQuadric> base_of(std::span<const Vec3> offsets) {
  Vec3 sum;
  for (const Vec3& offset : offsets) sum += offset;
  const auto count = static_cast<double>(offsets.size());
  const Vec3 mean = sum / count;
  Symmetric3 scatter{};
  for (const Vec3& offset : offsets) {
    const Vec3 d = offset - mean;
    const double row[6] = {d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.y, d.y * d.z, d.z * d.z};
    for (size_t c = 0; c < 6; ++c) scatter[c] += row[c];
  }
  const Eigen3 e = symmetric_eigen(scatter);
  if (!(e.values[1] > kQuadricPlaneLeastAspect * e.values[2])) return std::nullopt;
  TangentQuadric out;
  out.u = e.vectors[2];
  out.v = e.vectors[1];
  out.n = e.vectors[0];
  out.scale_m = std::sqrt((e.values[1] + e.values[2]) / count);
  return out;
}

}  // namespace

std::optional<TangentQuadric> local_quadric(const Octree& tree, size_t position,
                                            std::span<const uint32_t> neighbours) {
  const size_t count = std::min(neighbours.size(), kQuadricPlaneMost);
  if (count < kLeast) return std::nullopt;
  // Step 1: the offsets of the neighbours from the point.
  const double step = tree.grid_step();
  const int32_t *x = tree.grid_x(), *y = tree.grid_y(), *z = tree.grid_z();
  Vec3 offsets[kQuadricPlaneMost];
  for (size_t i = 0; i < count; ++i) {
    const uint32_t n = neighbours[i];
    offsets[i] =
        Vec3{static_cast<double>(x[n] - x[position]), static_cast<double>(y[n] - y[position]),
             static_cast<double>(z[n] - z[position])} *
        step;
  }
  std::optional<TangentQuadric> found = base_of({offsets, count});
  if (!found) return found;
  TangentQuadric& out = *found;
  // Step 3: least squares of the heights.
  Square<kQuadricPlaneUnknowns> normal{};
  Coefficients<kQuadricPlaneUnknowns> right{};
  double squares = 0;
  for (size_t i = 0; i < count; ++i) {
    const double height = dot(out.n, offsets[i]);
    const Coefficients<kQuadricPlaneUnknowns> q = out.terms(offsets[i]);
    for (size_t r = 0; r < kQuadricPlaneUnknowns; ++r) {
      right[r] += q[r] * height;
      for (size_t c = 0; c <= r; ++c) normal[kQuadricPlaneUnknowns * r + c] += q[r] * q[c];
    }
    squares += height * height;
  }
  Cholesky<kQuadricPlaneUnknowns> factor;
  if (!factor.factor(normal)) return std::nullopt;
  out.a = factor.solve(right);
  out.cofactors = factor.inverse();
  for (size_t i = 0; i < kQuadricPlaneUnknowns; ++i) squares -= out.a[i] * right[i];
  out.sigma_m =
      std::sqrt(std::max(0.0, squares) / static_cast<double>(count - kQuadricPlaneUnknowns));
  return found;
}

SurfacePlane tangent_plane(const Octree& tree, size_t position,
                           std::span<const uint32_t> neighbours, double most_m) {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  SurfacePlane out{{0, 0, 0}, 0, kNone, 0, 0, SurfaceShape::kPlane};
  const std::optional<TangentQuadric> found = local_quadric(tree, position, neighbours);
  if (!found || !(found->sigma_m <= most_m)) return out;
  const TangentQuadric& q = *found;
  const double du = q.a[1] / q.scale_m, dv = q.a[2] / q.scale_m, slope2 = du * du + dv * dv;
  if (slope2 > kSteepest * kSteepest) return out;
  const double length = std::sqrt(1 + slope2);
  const Vec3 normal = (q.n - q.u * du - q.v * dv) / length;
  for (int c = 0; c < 3; ++c) out.normal[c] = static_cast<float>(normal[c]);
  out.height_m = static_cast<float>(q.a[0] / length);
  out.sigma_m = static_cast<float>(q.sigma_m);
  out.tilt_rad = static_cast<float>(
      q.sigma_m * std::sqrt(0.5 * (q.cofactors[7] + q.cofactors[14])) / q.scale_m);
  out.radius_m = static_cast<float>(q.scale_m);
  out.shape = SurfaceShape::kQuadric;
  return out;
}

}  // namespace jalon
