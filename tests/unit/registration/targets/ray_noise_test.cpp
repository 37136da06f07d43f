// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The bias of spheres fitted to points with noise along their rays, by draws.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/targets/ray_noise.h"
#include "unit/registration/target_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kRayNoiseRadius_m = 0.0725, kRayNoiseNoise_m = 0.002;
constexpr int kDraws = 250, kSeen = 300;
const Vec3 kToScanner{1, 0, 0};

// The side of a ball about the origin that a scanner far along x sees, with noise along the rays or across the surface.
std::vector<Vec3> seen_side(bool along_rays, double noise_m, RandomStream& random) {
  std::vector<Vec3> out;
  while (out.size() < kSeen) {
    const Vec3 u = normalized(within(1, random));
    if (u.x < 0.1) continue;
    out.push_back(kRayNoiseRadius_m * u +
                  (along_rays ? kToScanner : u) * (noise_m * random.normal()));
  }
  return out;
}

// Least squares of the centre, and with the radius where it is free.
Sphere fitted_to(const std::vector<Vec3>& points, bool radius_known) {
  Sphere s{{}, kRayNoiseRadius_m};
  for (int step = 0; step < 15; ++step) {
    Square<4> normal{};
    Coefficients<4> right{};
    for (const Vec3& p : points) {
      const Vec3 u = normalized(p - s.centre);
      const double j[4] = {u.x, u.y, u.z, radius_known ? 0.0 : 1.0};
      for (size_t r = 0; r < 4; ++r) {
        right[r] += j[r] * s.distance(p);
        for (size_t c = 0; c < 4; ++c) normal[4 * r + c] += j[r] * j[c];
      }
    }
    if (radius_known) normal[15] = 1;
    Cholesky<4> factor;
    REQUIRE(factor.factor(normal));
    const Coefficients<4> x = factor.solve(right);
    s.centre += Vec3{x[0], x[1], x[2]};
    s.radius += x[3];
  }
  return s;
}

struct Mean {
  double sum = 0, squares = 0;
  void add(double v) { sum += v, squares += v * v; }
  double mean() const { return sum / kDraws; }
  double sigma() const { return std::sqrt((squares / kDraws - mean() * mean()) / kDraws); }
};

// Of the centre along the rays, as fitted and with the bias taken off, and of the radius after that.
struct Bias {
  Mean fitted, corrected, radius;
};
Bias bias_of(bool along_rays, bool radius_known) {
  const std::vector<Vec3> rays(kSeen, kToScanner);
  Bias out;
  for (uint64_t draw = 0; draw < kDraws; ++draw) {
    RandomStream random(181, draw);
    const auto points = seen_side(along_rays, kRayNoiseNoise_m, random);
    const Sphere fit = fitted_to(points, radius_known);
    const Sphere better = without_ray_bias(points, rays, fit, kRayNoiseNoise_m, radius_known);
    if (radius_known) CHECK(better.radius == kRayNoiseRadius_m);
    out.fitted.add(fit.centre.x);
    out.corrected.add(better.centre.x);
    out.radius.add(better.radius - kRayNoiseRadius_m);
  }
  return out;
}

}  // namespace

TEST_CASE("without_ray_bias__puts_the_mean_centre_where_the_sphere_is") {
  for (const bool radius_known : {false, true}) {
    const Bias bias = bias_of(true, radius_known);
    // Toward the scanner, beyond what draws leave open; after that, within it.
    CHECK(bias.fitted.mean() > 6 * bias.fitted.sigma());
    CHECK(std::abs(bias.corrected.mean()) < 4 * bias.corrected.sigma() + 0.05 * bias.fitted.mean());
    CHECK(std::abs(bias.radius.mean()) <= 4 * bias.radius.sigma());
  }
}

TEST_CASE("without_ray_bias__changes_little_where_noise_lies_across_the_surface") {
  const Bias along = bias_of(true, false), across = bias_of(false, false);
  const double taken = across.fitted.mean() - across.corrected.mean();
  // Half of all draws show a trace of it by chance.
  CHECK(std::abs(taken) < 0.4 * along.fitted.mean());
}

TEST_CASE("without_ray_bias__leaves_exact_points_and_points_of_one_incidence_alone") {
  RandomStream random(182, 0);
  const auto exact = seen_side(true, 0, random);
  const std::vector<Vec3> rays(kSeen, kToScanner);
  const Sphere truth{{}, kRayNoiseRadius_m},
      same = without_ray_bias(exact, rays, truth, kRayNoiseNoise_m, false);
  CHECK(norm(same.centre) < 1e-12);
  CHECK(std::abs(same.radius - kRayNoiseRadius_m) < 1e-12);
  // A slope against the incidence needs more than one of it: rays straight up from the surface.
  const auto noisy = seen_side(true, kRayNoiseNoise_m, random);
  std::vector<Vec3> upright;
  for (const Vec3& p : noisy) upright.push_back(normalized(p));
  CHECK(without_ray_bias(noisy, upright, truth, kRayNoiseNoise_m, false).centre == Vec3{});
}
