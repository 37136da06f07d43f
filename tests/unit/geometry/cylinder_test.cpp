// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/cylinder.h"

#include <doctest/doctest.h>

#include "unit/geometry/primitives.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("across__right_handed_frame_of_any_direction") {
  RandomStream random(1, 1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 d = normalized(Vec3{random.normal(), random.normal(), random.normal()});
    const auto e = across(d);
    CHECK(norm(cross(e[0], e[1]) - d) < 1e-12);
    CHECK(std::fabs(dot(e[0], d)) < 1e-12);
    CHECK(across(d) == e);
  }
  for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1}})
    CHECK(norm(cross(across(d)[0], across(d)[1]) - d) < 1e-12);
}

TEST_CASE("axis_from_covariance__long_cylinders_only") {
  Recipe recipe;
  recipe.outliers = 0;
  const Cylinder truth{{1, 2, 3}, normalized(Vec3{1, 1, 0.5}), 0.3};
  Vec3 axis;
  REQUIRE(axis_from_covariance(cylinder_draw(recipe, truth, 2.4, 1).points, axis));
  CHECK(std::fabs(dot(axis, truth.direction)) > 0.999);
  CHECK_FALSE(axis_from_covariance(cylinder_draw(recipe, truth, 0.6, 1).points, axis));
  CHECK_FALSE(axis_from_covariance(std::vector<Vec3>{{0, 0, 0}, {0, 0, 1}}, axis));
}

TEST_CASE("adjust_cylinder__direction_up_point_at_mid_height_and_covariance_of_rank_5") {
  Recipe recipe;
  recipe.outliers = 0;
  recipe.sigma_m = 0.002;
  const Cylinder truth{{1, 2, 3}, normalized(Vec3{0.2, -0.1, -1}), 0.25};
  const Draw draw = cylinder_draw(recipe, truth, 2, 4);
  Cylinder start = truth;  // off, and its point beyond the end
  start.point += 3 * truth.direction + Vec3{0.01, 0, 0};
  start.radius = 0.26;
  Task task;
  CylinderFit fit;
  REQUIRE(adjust_cylinder(draw.points, start, {}, task, fit));
  const Vec3 d = fit.cylinder.direction;
  CHECK(d.z > 0);
  CHECK(dot(d, truth.direction) < -0.99999);
  CHECK(std::fabs(fit.cylinder.radius - truth.radius) < 0.001);
  double low = INFINITY, high = -INFINITY;
  for (const Vec3& p : draw.points) {
    low = std::min(low, dot(p - fit.cylinder.point, d));
    high = std::max(high, dot(p - fit.cylinder.point, d));
  }
  CHECK(low + high == doctest::Approx(0).scale(1));
  CHECK(fit.length_m == doctest::Approx(high - low));
  // Nothing is known of shifts along the axis, nor of the length of the direction: two null vectors.
  for (const size_t offset : {size_t{0}, size_t{3}})
    for (size_t row = 0; row < 7; ++row) {
      double sum = 0;
      for (size_t k = 0; k < 3; ++k)
        sum += fit.covariance[7 * row + offset + k] * d[static_cast<int>(k)];
      CHECK(std::fabs(sum) < 1e-12);
    }
}

TEST_CASE("fit_cylinder_along__given_direction_is_kept_and_has_no_covariance") {
  Recipe recipe;
  const Vec3 direction = normalized(Vec3{0.6, 0, 0.8});
  const Cylinder truth{{652000, 10, 3}, direction, 0.4};
  Task task;
  CylinderFit fit;
  REQUIRE(fit_cylinder_along(direction, cylinder_draw(recipe, truth, 2, 6).points, {}, task, fit));
  CHECK(fit.cylinder.direction == direction);
  CHECK(fit.cylinder.axis_distance(truth.point) < 0.002);
  for (size_t row = 3; row < 6; ++row)
    for (size_t k = 0; k < 7; ++k) CHECK(fit.covariance[7 * row + k] == 0);
  CHECK(fit.covariance[48] > 0);
}
