// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/vertex_covariance.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kLeastDeterminant = 1e-3;  // of three unit normals: the volume they span

}  // namespace

// w = alpha u + beta v + gamma above the fit.
UncertainSurface plane_at(const PlaneFit& fit, const Vec3& point) {
  const Vec3 d = point - fit.centroid;
  const double u = dot(d, fit.axis_u), v = dot(d, fit.axis_v);
  const Symmetric3& c = fit.local_covariance;
  const double variance =
      c[0] * u * u + c[3] * v * v + c[5] + 2 * (c[1] * u * v + c[2] * u + c[4] * v);
  return {fit.plane.normal, std::sqrt(std::max(variance, 0.0))};
}

// n . p = offset moves along n at p by d offset - p . d n.
UncertainSurface plane_at(const Plane& plane, const std::array<double, 16>& covariance,
                          const Vec3& point) {
  const double gradient[4] = {-point.x, -point.y, -point.z, 1};
  double variance = 0;
  for (size_t i = 0; i < 4; ++i)
    for (size_t j = 0; j < 4; ++j) variance += gradient[i] * covariance[4 * i + j] * gradient[j];
  return {plane.normal, std::sqrt(std::max(variance, 0.0))};
}

UncertainSurface edge_at(const PlaneFrame& frame, const Vec2& direction, double sigma_m,
                         double sigma_direction_rad, double lever_m) {
  const Vec2 along = direction * (1 / norm(direction));
  return {frame.axis_u * -along.v + frame.axis_v * along.u,
          std::hypot(sigma_m, sigma_direction_rad * lever_m)};
}

std::optional<Covariance3> vertex_covariance(const std::array<UncertainSurface, 3>& surfaces) {
  const Vec3 &a = surfaces[0].normal, &b = surfaces[1].normal, &c = surfaces[2].normal;
  const double determinant = dot(a, cross(b, c));
  if (!(std::fabs(determinant) >= kLeastDeterminant)) return std::nullopt;
  for (const UncertainSurface& surface : surfaces)
    if (!std::isfinite(surface.sigma_m)) return std::nullopt;
  // The columns of N^-1: how far the vertex moves when one surface moves along its normal by a unit.
  const Vec3 moves[3] = {cross(b, c) / determinant, cross(c, a) / determinant,
                         cross(a, b) / determinant};
  Covariance3 out{};
  for (int k = 0; k < 3; ++k) {
    const double variance =
        surfaces[static_cast<size_t>(k)].sigma_m * surfaces[static_cast<size_t>(k)].sigma_m;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        out[static_cast<size_t>(3 * i + j)] += variance * moves[k][i] * moves[k][j];
  }
  return out;
}

std::optional<Covariance3> corner_covariance(const PlaneFrame& frame, const UncertainSurface& plane,
                                             const CornerEdge& before, const CornerEdge& after) {
  const auto edge = [&](const CornerEdge& e) {
    return edge_at(frame, e.direction, e.sigma_m, e.sigma_direction_rad, e.length_m / 2);
  };
  return vertex_covariance({plane, edge(before), edge(after)});
}

}  // namespace jalon
