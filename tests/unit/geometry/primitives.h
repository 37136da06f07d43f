// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <vector>

#include "base/random.h"
#include "geometry/cholesky.h"
#include "geometry/cylinder.h"
#include "geometry/sphere.h"

namespace jalon::test {

/// How the noise of a scan lies: along the surface normal, the same in all directions, or along the beam.
enum class Noise { kNormal, kIsotropic, kBeam };

struct Draw {
  std::vector<Vec3> points, normals;
};

inline bool is_full() { return std::getenv("JALON_FULL") != nullptr; }
/// 2 000 draws, so that chance moves a share of 95 % by less than 0.5 %; 100 under the sanitizers.
inline int draw_count() { return std::getenv("JALON_SANITIZED") != nullptr ? 100 : 2000; }

struct Recipe {
  size_t n = 800;
  double sigma_m = 0.003, outliers = 0.05;
  bool one_sided = false;
  Noise noise = Noise::kNormal;
  bool near =
      false;  ///< outliers within 5 cm of the surface, where they do most harm; else all over the box
  Vec3 eye{-12, 4, 1.7};
};

inline Vec3 noise_of(const Recipe& recipe, const Vec3& p, const Vec3& normal,
                     RandomStream& random) {
  if (recipe.noise == Noise::kNormal) return recipe.sigma_m * random.normal() * normal;
  if (recipe.noise == Noise::kBeam)
    return recipe.sigma_m * random.normal() * normalized(p - recipe.eye);
  return recipe.sigma_m * Vec3{random.normal(), random.normal(), random.normal()};
}

/// Points that `place` puts on a surface with their normals, with noise, and outliers in the box of the points.
inline Draw draw_of(const Recipe& recipe, uint64_t seed,
                    const std::function<Vec3(RandomStream&, Vec3&)>& place) {
  RandomStream random(seed, 17);
  Draw out;
  Box3 box;
  while (out.points.size() < recipe.n) {
    Vec3 normal;
    const Vec3 p = place(random, normal);
    if (recipe.one_sided && dot(recipe.eye - p, normal) < 0.1 * norm(recipe.eye - p)) continue;
    box.add(p);
    const Vec3 tilt{0.1 * random.normal(), 0.1 * random.normal(), 0.1 * random.normal()};
    out.points.push_back(p + noise_of(recipe, p, normal, random));
    out.normals.push_back(normalized(normal + tilt));
  }
  const auto gross = static_cast<size_t>(recipe.outliers * static_cast<double>(recipe.n));
  const Vec3 low = box.min - Vec3{0.3, 0.3, 0.3}, side = box.max - box.min + Vec3{0.6, 0.6, 0.6};
  for (size_t i = 0; i < gross; ++i) {
    Vec3 normal;
    const Vec3 p = place(random, normal);
    const Vec3 anywhere =
        low + Vec3{side.x * random.uniform(), side.y * random.uniform(), side.z * random.uniform()};
    out.points[i] = recipe.near ? p + 0.1 * (random.uniform() - 0.5) * normal : anywhere;
    out.normals[i] = normalized(Vec3{random.normal(), random.normal(), random.normal()});
  }
  return out;
}

inline Draw sphere_draw(const Recipe& recipe, const Sphere& truth, uint64_t seed) {
  return draw_of(recipe, seed, [&](RandomStream& random, Vec3& normal) {
    normal = normalized(Vec3{random.normal(), random.normal(), random.normal()});
    return truth.centre + truth.radius * normal;
  });
}

inline Draw cylinder_draw(const Recipe& recipe, const Cylinder& truth, double length_m,
                          uint64_t seed) {
  const auto e = across(truth.direction);
  return draw_of(recipe, seed, [&](RandomStream& random, Vec3& normal) {
    const double angle = 2 * std::numbers::pi * random.uniform(),
                 h = length_m * (random.uniform() - 0.5);
    normal = std::cos(angle) * e[0] + std::sin(angle) * e[1];
    return truth.point + h * truth.direction + truth.radius * normal;
  });
}

/// Squared Mahalanobis distance.
template <size_t K>
double mahalanobis(const Coefficients<K>& error, const Square<K>& covariance) {
  Cholesky<K> factor;
  if (!factor.factor(covariance)) return INFINITY;
  const Coefficients<K> x = factor.solve(error);
  double sum = 0;
  for (size_t i = 0; i < K; ++i) sum += error[i] * x[i];
  return sum;
}

/// Four unknowns: centre and radius.
inline double sphere_miss(const SphereFit& fit, const Sphere& truth) {
  const Vec3 d = fit.sphere.centre - truth.centre;
  return mahalanobis<4>({d.x, d.y, d.z, fit.sphere.radius - truth.radius}, fit.covariance);
}

/// Five unknowns: shift and turn of the axis across itself, and the radius.
inline double cylinder_miss(const CylinderFit& fit, const Cylinder& truth) {
  const Vec3 a = fit.cylinder.direction;
  const Vec3 b = dot(truth.direction, a) < 0 ? -truth.direction : truth.direction;
  const auto e = across(a);
  // Where the true axis crosses the plane through the fitted point, and how it leans there.
  const Vec3 d = truth.point - fit.cylinder.point;
  const Vec3 foot = d - dot(d, a) / dot(b, a) * b;
  const Coefficients<5> error{-dot(foot, e[0]), -dot(foot, e[1]), -dot(b, e[0]) / dot(b, a),
                              -dot(b, e[1]) / dot(b, a), fit.cylinder.radius - truth.radius};
  std::array<double, 35> j{};  // 5 x 7
  for (size_t k = 0; k < 2; ++k)
    for (size_t i = 0; i < 3; ++i) {
      j[7 * k + i] = e[k][static_cast<int>(i)];
      j[7 * (2 + k) + 3 + i] = e[k][static_cast<int>(i)];
    }
  j[7 * 4 + 6] = 1;
  return mahalanobis<5>(error, propagated<5, 7>(j, fit.covariance));
}

constexpr double kChiSquare4 = 9.4877, kChiSquare5 = 11.0705;  ///< 95 %

}  // namespace jalon::test
