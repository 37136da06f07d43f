// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/ray_noise.h"

#include <cmath>
#include <optional>

namespace jalon {

namespace {

constexpr double kReach = 4;  // standard deviations: what lies beyond is no noise

// Slope of d^2 against cos^2 of incidence.
double ray_variance(std::span<const Vec3> points, std::span<const Vec3> rays, const Sphere& sphere,
                    double reach_m) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double d = sphere.distance(points[i]),
                 c = dot(rays[i], normalized(points[i] - sphere.centre));
    if (std::fabs(d) > reach_m) continue;
    ++n, x += c * c, y += d * d, xx += c * c * c * c, xy += c * c * d * d;
  }
  const double spread = n * xx - x * x;
  return n > 0 && spread > 1e-3 * n * n ? std::max(0.0, (n * xy - x * y) / spread) : 0;
}

// Of the centre and, for K = 4, the radius; none where the points do not fix them.
template <size_t K>
std::optional<Coefficients<K>> bias_of(std::span<const Vec3> points, std::span<const Vec3> rays,
                                       const Sphere& sphere, double reach_m, double variance_m2) {
  Square<K> normal{};
  Coefficients<K> score{};
  for (size_t i = 0; i < points.size(); ++i) {
    if (std::fabs(sphere.distance(points[i])) > reach_m) continue;
    const Vec3 u = normalized(points[i] - sphere.centre);
    const double c = dot(rays[i], u), slant = (1 - c * c) / (2 * sphere.radius);
    // E[u' d]: u' = u + e (q - c u) / r and d = e c + e^2 (1 - c^2) / (2 r), with e along the ray q.
    const Vec3 turned = (c / sphere.radius) * (rays[i] - c * u) + slant * u;
    Coefficients<K> j{u.x, u.y, u.z};
    if constexpr (K == 4) j[3] = 1;
    for (size_t r = 0; r < K; ++r) {
      score[r] += variance_m2 * (r < 3 ? turned[static_cast<int>(r)] : slant);
      for (size_t k = 0; k < K; ++k) normal[K * r + k] += j[r] * j[k];
    }
  }
  Cholesky<K> factor;
  if (!factor.factor(normal)) return std::nullopt;
  return factor.solve(score);
}

}  // namespace

Sphere without_ray_bias(std::span<const Vec3> points, std::span<const Vec3> rays,
                        const Sphere& fitted, double sigma_m, bool radius_known) {
  const double reach_m = kReach * sigma_m, variance = ray_variance(points, rays, fitted, reach_m);
  Sphere out = fitted;
  if (radius_known) {
    if (const auto shift = bias_of<3>(points, rays, fitted, reach_m, variance))
      out.centre -= Vec3{(*shift)[0], (*shift)[1], (*shift)[2]};
  } else if (const auto both = bias_of<4>(points, rays, fitted, reach_m, variance)) {
    out.centre -= Vec3{(*both)[0], (*both)[1], (*both)[2]};
    out.radius -= (*both)[3];
  }
  return out;
}

}  // namespace jalon
