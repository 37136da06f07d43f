// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/numbers.h"
#include "geometry/circle.h"
#include "unit/geometry/primitives.h"

namespace jalon {
namespace {

using namespace test;

std::vector<Vec3> flat_patch(size_t n, double noise_m) {
  RandomStream random(5, 0);
  std::vector<Vec3> out;
  for (size_t i = 0; i < n; ++i)
    out.push_back({random.uniform(), random.uniform(), noise_m * random.normal()});
  return out;
}

TEST_CASE("sphere_through__four_points__both_ways_agree_far_from_the_origin") {
  const Sphere truth{{652000.4, 6861000.2, 40.5}, 0.9};
  std::array<Vec3, 4> points;
  const Vec3 directions[4] = {{1, 0, 0.1}, {0, 1, 0.3}, {-1, 0.2, 0}, {0.1, -0.3, 1}};
  for (size_t i = 0; i < 4; ++i)
    points[i] = truth.centre + truth.radius * normalized(directions[i]);
  Sphere geometric, linear;
  REQUIRE(sphere_through(points, geometric));
  REQUIRE(sphere_linear(points, linear));
  for (const Sphere& s : {geometric, linear}) {
    CHECK(norm(s.centre - truth.centre) < 1e-7);
    CHECK(std::fabs(s.radius - truth.radius) < 1e-7);
  }
}

TEST_CASE("fit_sphere__too_few_or_flat_points__refused") {
  Task task;
  SphereFit fit;
  Sphere sphere;
  CHECK_FALSE(sphere_through({Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, sphere));
  CHECK_FALSE(fit_sphere(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, task, fit));
  CHECK_FALSE(fit_sphere(std::vector<Vec3>(50, Vec3{1, 2, 3}), {}, task, fit));
  CHECK_FALSE(fit_sphere(flat_patch(500, 0), {}, task, fit));
  CHECK_FALSE(
      fit_sphere(flat_patch(500, 0.003), {}, task, fit));  // a wall is no sphere of a kilometre
  std::vector<Vec3> line;
  for (int i = 0; i < 50; ++i) line.push_back({0.1 * i, 0.2 * i, 0.3 * i});
  CHECK_FALSE(fit_sphere(line, {}, task, fit));
}

TEST_CASE("fit_sphere__radius_limits__decide") {
  Recipe recipe;
  recipe.outliers = 0;
  const Draw draw = sphere_draw(recipe, {{0, 0, 0}, 0.9}, 3);
  Task task;
  SphereFit fit;
  PrimitiveSetting setting;
  setting.max_radius_m = 0.8;
  CHECK_FALSE(fit_sphere(draw.points, setting, task, fit));
  setting.max_radius_m = 1;
  CHECK(fit_sphere(draw.points, setting, task, fit));
  setting.min_radius_m = 0.95;
  CHECK_FALSE(fit_sphere(draw.points, setting, task, fit));
}

TEST_CASE("fit_sphere__least_squares__covariance_is_sigma2_over_JtJ") {
  Recipe recipe;
  recipe.outliers = 0;
  recipe.n = 100;
  const Sphere truth{{0.2, 0.3, 0.4}, 0.5};
  PrimitiveSetting setting;
  setting.robust = false;
  Task task;
  int covered = 0;
  for (int i = 0; i < draw_count(); ++i) {
    SphereFit fit;
    REQUIRE(fit_sphere(sphere_draw(recipe, truth, static_cast<uint64_t>(i)).points, setting, task,
                       fit));
    CHECK(fit.n == 100);
    covered += sphere_miss(fit, truth) <= kChiSquare4;
  }
  const double share = static_cast<double>(covered) / draw_count();
  MESSAGE("FIGURE sphere, 100 points, least squares: 95 % ellipsoid covers " << 100 * share
                                                                             << " %");
  CHECK(share > 0.91);
  CHECK(share < 0.98);
}

TEST_CASE("fit_sphere__four_picks__exact_without_a_covariance") {
  Task task;
  SphereFit fit;
  REQUIRE(
      fit_sphere(std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, {}, task, fit));
  CHECK(norm(fit.sphere.centre) < 1e-9);
  CHECK(fit.sphere.radius == doctest::Approx(1));
  CHECK(fit.sigma == 0);
  CHECK(std::isnan(fit.covariance[0]));
}

TEST_CASE("fit_circle__noise_and_outliers__ellipse_covers_the_truth") {
  Task task;
  int covered = 0;
  for (int i = 0; i < draw_count(); ++i) {
    RandomStream random(static_cast<uint64_t>(i), 3);
    std::vector<Vec2> points;
    for (int k = 0; k < 400; ++k) {
      const double angle = 3 * random.uniform(), r = 0.4 + 0.003 * random.normal();
      const bool gross = k % 20 == 0;
      points.push_back(gross ? Vec2{random.uniform(), random.uniform()}
                             : Vec2{r * std::cos(angle), r * std::sin(angle)});
    }
    CircleFit fit;
    REQUIRE(fit_circle(points, {}, task, fit));
    const Circle& c = fit.circle;
    covered += mahalanobis<3>({c.centre.u, c.centre.v, c.radius - 0.4}, fit.covariance) <= 7.8147;
  }
  const double share = static_cast<double>(covered) / draw_count();
  MESSAGE("FIGURE circle r 0.4 m over 172 degrees: 95 % ellipsoid covers " << 100 * share << " %");
  CHECK(share >= 0.93);
  CHECK(share <= 0.97);
}

TEST_CASE("cylinder_from_normals__two_points__axis_and_radius") {
  Cylinder c;
  REQUIRE(cylinder_from_normals({2.3, 1, 5}, {1, 0, 0}, {2, 1.3, 7}, {0, -1, 0},
                                c));  // normals of either side
  CHECK(std::fabs(c.direction.z) == doctest::Approx(1));
  CHECK(c.point.x == doctest::Approx(2));
  CHECK(c.point.y == doctest::Approx(1));
  CHECK(c.radius == doctest::Approx(0.3));
  CHECK_FALSE(cylinder_from_normals({2.3, 1, 5}, {1, 0, 0}, {1.7, 1, 7}, {-1, 0, 0}, c));
}

TEST_CASE("cylinder_along__three_picks_at_any_height__vertical_cylinder") {
  Cylinder c;
  REQUIRE(
      cylinder_along({0, 0, 1}, std::vector<Vec3>{{1.25, 2, 0}, {1, 2.25, 3}, {0.75, 2, 1}}, c));
  CHECK(c.point.x == doctest::Approx(1));
  CHECK(c.point.y == doctest::Approx(2));
  CHECK(c.radius == doctest::Approx(0.25));
  CHECK_FALSE(cylinder_along({0, 0, 1}, std::vector<Vec3>{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}, c));
}

TEST_CASE("fit_cylinder__without_normals__long_ones_only") {
  Recipe recipe;
  recipe.sigma_m = 0.002;
  const Cylinder truth{{1, 2, 3}, normalized(Vec3{0.3, 0.2, 1}), 0.3};
  Task task;
  CylinderFit fit;
  REQUIRE(fit_cylinder(cylinder_draw(recipe, truth, 2.0, 1).points, {}, {}, task, fit));
  CHECK(std::fabs(dot(fit.cylinder.direction, truth.direction)) > 0.999999);
  CHECK(fit.cylinder.radius == doctest::Approx(0.3).epsilon(0.005).scale(0));
  CHECK(fit.cylinder.axis_distance(truth.point) < 0.002);
  // 0.6 m high, 0.6 m wide: the covariance does not tell the axis, the normals do.
  const Draw low = cylinder_draw(recipe, truth, 0.6, 2);
  CHECK_FALSE(fit_cylinder(low.points, {}, {}, task, fit));
  REQUIRE(fit_cylinder(low.points, low.normals, {}, task, fit));
  CHECK(std::fabs(dot(fit.cylinder.direction, truth.direction)) > 0.9999);
}

TEST_CASE("fit_cylinder__flat_or_few_points__refused") {
  Task task;
  CylinderFit fit;
  const std::vector<Vec3> flat = flat_patch(500, 0.003);
  std::vector<Vec3> normals;
  RandomStream random(8, 0);
  for (size_t i = 0; i < flat.size(); ++i)
    normals.push_back(normalized(Vec3{0.05 * random.normal(), 0.05 * random.normal(), 1}));
  PrimitiveSetting setting;
  setting.max_radius_m = 5;
  CHECK_FALSE(fit_cylinder(flat, normals, setting, task, fit));
  CHECK_FALSE(fit_cylinder(std::vector<Vec3>(4), std::vector<Vec3>(4), {}, task, fit));
  CHECK_FALSE(
      fit_cylinder(std::vector<Vec3>(100), std::vector<Vec3>(100, Vec3{0, 0, 1}), {}, task, fit));
  CHECK_FALSE(
      fit_cylinder(flat, std::vector<Vec3>(flat.size(), Vec3{kNaN, kNaN, kNaN}), {}, task, fit));
}

TEST_CASE("fit_cylinder_along__noise_and_outliers__covers_the_truth") {
  const Cylinder truth{{4, 5, 6}, {0, 0, 1}, 0.2};
  Recipe recipe;
  recipe.one_sided = true;
  Task task;
  int covered = 0;
  for (int i = 0; i < draw_count(); ++i) {
    CylinderFit fit;
    REQUIRE(fit_cylinder_along({0, 0, 1},
                               cylinder_draw(recipe, truth, 2.5, static_cast<uint64_t>(i)).points,
                               {}, task, fit));
    const Vec3 d = fit.cylinder.point - truth.point;
    Square<3> covariance;
    constexpr size_t kAt[3] = {0, 1, 6};
    for (size_t r = 0; r < 3; ++r)
      for (size_t c = 0; c < 3; ++c) covariance[3 * r + c] = fit.covariance[7 * kAt[r] + kAt[c]];
    covered += mahalanobis<3>({d.x, d.y, fit.cylinder.radius - truth.radius}, covariance) <= 7.8147;
  }
  const double share = static_cast<double>(covered) / draw_count();
  MESSAGE("FIGURE vertical cylinder r 0.2 m from one side: 95 % ellipsoid covers " << 100 * share
                                                                                   << " %");
  CHECK(share >= 0.93);
  CHECK(share <= 0.97);
}

TEST_CASE("fits__any_number_of_threads__same_bits") {
  Recipe recipe;
  recipe.n = 30000;
  const Draw ball = sphere_draw(recipe, {{1, 2, 3}, 0.9}, 1),
             pipe = cylinder_draw(recipe, {{1, 2, 3}, {0, 0, 1}, 0.2}, 2, 1);
  SphereFit s[3];
  CylinderFit c[3];
  constexpr unsigned kThreads[3] = {1, 2, 7};
  for (size_t i = 0; i < 3; ++i) {
    Task::Hooks hooks;
    hooks.threads = kThreads[i];
    Task task(hooks);
    REQUIRE(fit_sphere(ball.points, {}, task, s[i]));
    REQUIRE(fit_cylinder(pipe.points, pipe.normals, {}, task, c[i]));
    CHECK(s[i].sphere.centre == s[0].sphere.centre);
    CHECK(s[i].covariance == s[0].covariance);
    CHECK(c[i].cylinder.point == c[0].cylinder.point);
    CHECK(c[i].cylinder.direction == c[0].cylinder.direction);
    CHECK(c[i].covariance == c[0].covariance);
  }
}

}  // namespace
}  // namespace jalon
