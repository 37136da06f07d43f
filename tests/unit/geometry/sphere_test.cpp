// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/sphere.h"

#include <doctest/doctest.h>

#include "unit/geometry/primitives.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("sphere_from_normals__lines_that_cross__give_the_sphere") {
  const Vec3 centre{3, -1, 2}, a = normalized(Vec3{1, 2, 0.5}), b = normalized(Vec3{-1, 0.3, 1});
  Sphere s;
  REQUIRE(sphere_from_normals(centre + 0.7 * a, a, centre + 0.7 * b, -b, s));  // of either side
  CHECK(norm(s.centre - centre) < 1e-12);
  CHECK(s.radius == doctest::Approx(0.7));
  CHECK(s.distance(centre + 2 * a) == doctest::Approx(1.3));
  CHECK(s.distance(centre) == doctest::Approx(-0.7));
}

TEST_CASE("sphere_from_normals__skew_lines__centre_halfway_between_them") {
  Sphere s;
  REQUIRE(sphere_from_normals({1, 0, 0.1}, {1, 0, 0}, {0, 1, -0.1}, {0, 1, 0}, s));
  CHECK(norm(s.centre) < 1e-12);
  CHECK(s.radius == doctest::Approx(std::hypot(1, 0.1)));
  CHECK_FALSE(sphere_from_normals({1, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}, s));
  CHECK_FALSE(sphere_from_normals({1, 0, 0}, {1, 0, 0}, {0, 1, 0}, normalized(Vec3{1, 0.03, 0}),
                                  s));  // nearly parallel
}

TEST_CASE("sphere_linear__more_points_than_four__exact_and_refused_when_flat") {
  RandomStream random(6, 6);
  std::vector<Vec3> points, flat;
  const Vec3 centre{652000.5, 6861000.25, 30};
  for (int i = 0; i < 50; ++i) {
    const Vec3 d = normalized(Vec3{random.normal(), random.normal(), std::fabs(random.normal())});
    points.push_back(centre + 1.5 * d);
    flat.push_back({random.uniform(), random.uniform(), 0});
  }
  Sphere s;
  REQUIRE(sphere_linear(points, s));
  CHECK(norm(s.centre - centre) < 1e-6);
  CHECK(std::fabs(s.radius - 1.5) < 1e-6);
  CHECK_FALSE(sphere_linear(flat, s));
  CHECK_FALSE(sphere_linear(std::span(points).first(3), s));
}

TEST_CASE("adjust_sphere__least_squares__gradient_vanishes_and_sigma_has_n_minus_4") {
  Recipe recipe;
  recipe.n = 60;
  recipe.outliers = 0;
  recipe.sigma_m = 0.005;
  const Draw draw = sphere_draw(recipe, {{1, 2, 3}, 0.8}, 2);
  PrimitiveSetting setting;
  setting.robust = false;
  Task task;
  SphereFit fit;
  REQUIRE(adjust_sphere(draw.points, {{1.05, 2, 2.9}, 0.7}, setting, task, fit));
  Vec3 by_centre;
  double by_radius = 0, squares = 0;
  for (const Vec3& p : draw.points) {
    const double d = fit.sphere.distance(p);
    by_centre += d * normalized(p - fit.sphere.centre);
    by_radius += d;
    squares += d * d;
  }
  CHECK(norm(by_centre) < 1e-9);
  CHECK(std::fabs(by_radius) < 1e-9);
  CHECK(fit.sigma == doctest::Approx(std::sqrt(squares / 56)).scale(0));
}
