// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/scale_test.h"

#include <algorithm>
#include <cmath>

#include "geometry/cholesky.h"

namespace jalon {

namespace {

constexpr size_t kUnknowns = 7;  // turn, shift, scale
constexpr size_t kLeastPairs = 50;
constexpr double kScaleNear = 4,
                 kMostHeight = 0.3;  // reaches: beyond, a neighbour is of another surface
constexpr double kScaleFacing = 0.9;
// Noises that the planes must lie apart about their middle, as the scale sees them: what noise alone puts there
// correlates with the residuals, and would give a scale that is off by the inverse square.
constexpr double kLeastLever = 50;
constexpr double kWidth = 3;  // noises at which a residual counts half (Cauchy's weight)

}  // namespace

ScaleTest scale_test(const JudgedCloud& reference, const JudgedCloud& moving,
                     const Transform& T_reference_moving) {
  const SurfacePlanes& surface = *reference.surface;
  const double reach_m = std::max(surface.radius_m, moving.surface->radius_m);
  const double noise_m = std::hypot(surface.noise_m, moving.surface->noise_m);
  const double width_m = std::max(kWidth * noise_m, 1e-12);
  Vec3 centre;
  for (const Surfel& surfel : moving.surfels) centre += T_reference_moving.point(surfel.place);
  centre = centre / std::max(1.0, static_cast<double>(moving.surfels.size()));
  Square<kUnknowns> normal{};
  Coefficients<kUnknowns> right{};
  ScaleTest out;
  double squares = 0;
  for (const Surfel& surfel : moving.surfels) {
    const Vec3 place = T_reference_moving.point(surfel.place);
    Neighbour found;
    if (surface.tree->knn_positions(surface.tree->cube().origin + place, 1, {&found, 1}) == 0)
      continue;
    if (std::sqrt(found.squared_distance) > kScaleNear * reach_m || !surface.flat(found.index))
      continue;
    const SurfacePlane& plane = surface.planes[found.index];
    const Vec3 n = plane.unit();
    if (std::abs(dot(n, T_reference_moving.direction(surfel.normal))) < kScaleFacing) continue;
    const double height = dot(n, place - surface.place(found.index)) - double{plane.height_m};
    if (std::abs(height) > kMostHeight * reach_m) continue;
    const Vec3 arm = place - centre, turn = cross(arm, n);
    const double j[kUnknowns] = {turn.x, turn.y, turn.z, n.x, n.y, n.z, dot(arm, n)};
    const double weight = 1 / (1 + height * height / (width_m * width_m));
    for (size_t a = 0; a < kUnknowns; ++a) {
      for (size_t b = 0; b < kUnknowns; ++b) normal[kUnknowns * a + b] += weight * j[a] * j[b];
      right[a] -= weight * j[a] * height;
    }
    squares += weight * height * height;
    ++out.pairs;
  }
  Cholesky<kUnknowns> factor;
  if (out.pairs < kLeastPairs || !factor.factor(normal)) return out;
  const double variance = std::max(squares / static_cast<double>(out.pairs), noise_m * noise_m);
  const double cofactor = factor.inverse()[kUnknowns * kUnknowns - 1];
  const double lever_m = kLeastLever * noise_m;
  if (cofactor * lever_m * lever_m * static_cast<double>(out.pairs) > 1) return out;
  out.scale = 1 + factor.solve(right)[kUnknowns - 1];
  out.sigma = std::sqrt(variance * cofactor);
  return out;
}

}  // namespace jalon
