// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/quadric.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"

namespace jalon {
namespace {

std::vector<Vec3> samples(const Quadric& q, double size, size_t n) {
  RandomStream random(4, 0);
  std::vector<Vec3> points;
  for (size_t i = 0; i < n; ++i) {
    const double x = size * (2 * random.uniform() - 1), y = size * (2 * random.uniform() - 1);
    points.push_back({x, y, q.height(x, y)});
  }
  return points;
}

TEST_CASE("fit_quadric__exact_samples__gives_the_coefficients_back") {
  const Quadric truth{0.3, -0.1, 0.25, 0.05, -0.4, 0.02};
  for (const double size : {0.01, 1.0, 100.0}) {
    Quadric q;
    REQUIRE(fit_quadric(samples(truth, size, 20), size, q));
    CHECK(q.a == doctest::Approx(truth.a).epsilon(1e-6));
    CHECK(q.c == doctest::Approx(truth.c).epsilon(1e-6));
    CHECK(q.e == doctest::Approx(truth.e).epsilon(1e-6));
    CHECK(q.f == doctest::Approx(truth.f).epsilon(1e-6));
  }
}

TEST_CASE("fit_quadric__of_sums_is_that_of_the_points") {
  RandomStream random(6, 0);
  std::vector<Vec3> points = samples({0.3, -0.1, 0.25, 0.05, -0.4, 0.02}, 1, 300);
  for (Vec3& p : points) p.z += 0.01 * random.normal();
  QuadricSums sums{};
  for (const Vec3& p : points)
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; i + j <= 4; ++j) {
        const double power = std::pow(p.x, i) * std::pow(p.y, j);
        sums.powers[i][j] += power;
        if (i + j <= 2) sums.heights[i][j] += power * p.z;
      }
  Quadric a, b;
  REQUIRE(fit_quadric(points, 1, a));
  REQUIRE(fit_quadric(sums, b));
  CHECK(b.a == doctest::Approx(a.a).epsilon(1e-10));
  CHECK(b.b == doctest::Approx(a.b).epsilon(1e-10));
  CHECK(b.c == doctest::Approx(a.c).epsilon(1e-10));
  CHECK(b.d == doctest::Approx(a.d).epsilon(1e-10));
  CHECK(b.e == doctest::Approx(a.e).epsilon(1e-10));
  CHECK(b.f == doctest::Approx(a.f).epsilon(1e-10));
  sums.powers[0][0] = 5;
  CHECK_FALSE(fit_quadric(sums, b));
  CHECK_FALSE(fit_quadric(QuadricSums{}, b));
}

TEST_CASE("quadric_curvature__sphere_cylinder_saddle__known_values") {
  // Osculating paraboloids at the origin of a sphere and a cylinder of radius 2, and of a saddle.
  const Quadric sphere{0.25, 0, 0, 0, 0.25, 0}, cylinder{0.25, 0, 0, 0, 0, 0},
      saddle{0.5, 0, 0, 0, -0.5, 0};
  CHECK(sphere.mean_curvature(0, 0) == doctest::Approx(0.5));
  CHECK(sphere.gaussian_curvature(0, 0) == doctest::Approx(0.25));
  CHECK(cylinder.mean_curvature(0, 0) == doctest::Approx(0.25));
  CHECK(cylinder.gaussian_curvature(0, 0) == 0);
  CHECK(saddle.mean_curvature(0, 0) == 0);
  CHECK(saddle.gaussian_curvature(0, 0) == doctest::Approx(-1));
}

TEST_CASE("quadric_normal__a_slanted_plane") {
  const Quadric plane{0, 0.75, 0, 0, 0, 1};
  const Vec3 n = plane.normal(3, 4);
  CHECK(n.x == doctest::Approx(-0.6));
  CHECK(n.y == 0);
  CHECK(n.z == doctest::Approx(0.8));
}

TEST_CASE("fit_quadric__too_few_or_on_one_conic__false") {
  Quadric q;
  const Quadric truth{1, 0, 0, 0, 1, 0};
  CHECK_FALSE(fit_quadric(samples(truth, 1, 5), 1, q));
  CHECK_FALSE(fit_quadric({}, 1, q));
  std::vector<Vec3> circle, line;
  for (int i = 0; i < 20; ++i) {
    circle.push_back({std::cos(i), std::sin(i), 0.1 * i});
    line.push_back({0.1 * i, 0.2 * i, 0});
  }
  CHECK_FALSE(fit_quadric(circle, 1, q));
  CHECK_FALSE(fit_quadric(line, 1, q));
  CHECK_FALSE(fit_quadric(std::vector<Vec3>(10, Vec3{1, 1, 1}), 1, q));
}

}  // namespace
}  // namespace jalon
