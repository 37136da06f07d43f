// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What is a curved surface and what is none, on pipes, balls, corners, posts, bands and clutter whose truth is known.
#include <doctest/doctest.h>

#include <cmath>

#include "segment/ransac/curved_checks.h"
#include "unit/segment/curved_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kCheckNoise_m = 0.003;

// A surface of this shape with the rms of its points about it.
Surface about(const Curved& curved, const std::vector<Vec3>& points) {
  Surface out;
  out.curved = curved;
  double squares = 0;
  for (const Vec3& p : points) squares += std::pow(curved.distance(p), 2);
  out.sigma_m = std::sqrt(squares / static_cast<double>(points.size()));
  return out;
}

bool pipe_bends(double turn_rad, double noise_m = kCheckNoise_m) {
  Scene scene;
  RandomStream random(1, 21);
  const Cylinder pipe{{0, 0, 0}, {0, 0, 1}, 0.25};
  add_pipe(scene, 1, {pipe, 1, turn_rad}, 2000, noise_m, random);
  Task task;
  return bends({}, about(Curved(pipe), scene.points), scene.points, task);
}

bool cap_bends(double half_rad) {
  Scene scene;
  RandomStream random(2, 21);
  const Sphere ball{{1, 2, 3}, 0.6};
  add_ball(scene, 1, ball, std::cos(half_rad), 2000, kCheckNoise_m, random);
  Task task;
  return bends({}, about(Curved(ball), scene.points), scene.points, task);
}

// Points on the walls of an upright prism of so many sides about the Z axis, which the circle `inner_m` touches.
std::vector<Vec3> prism(int sides, double inner_m) {
  RandomStream random(3, 21);
  std::vector<Vec3> out;
  const double half = inner_m * std::tan(std::numbers::pi / sides);
  for (int i = 0; i < 3000; ++i) {
    const double a = kFullTurn_rad * static_cast<double>(i % sides) / sides;
    const Vec3 n{std::cos(a), std::sin(a), 0}, u{-n.y, n.x, 0};
    const double away = inner_m + kCheckNoise_m * random.normal(),
                 aside = half * (2 * random.uniform() - 1);
    out.push_back(away * n + aside * u + Vec3{0, 0, random.uniform()});
  }
  return out;
}

bool faceted_about_z(const std::vector<Vec3>& points) {
  Cylinder mean{{0, 0, 0}, {0, 0, 1}, 0};
  for (const Vec3& p : points)
    mean.radius += mean.axis_distance(p) / static_cast<double>(points.size());
  Task task;
  return is_faceted(about(Curved(mean), points), points, task);
}

}  // namespace

TEST_CASE("curved_checks__a_surface_bends_from_twice_the_normal_tolerance_on") {
  // 2 x 25 degrees = 0.87 rad.
  CHECK(pipe_bends(kFullTurn_rad));
  CHECK(pipe_bends(1.2));
  CHECK_FALSE(pipe_bends(0.8));
  CHECK(cap_bends(std::numbers::pi));
  CHECK(cap_bends(0.6));
  CHECK_FALSE(cap_bends(0.4));
  // A turn of 1.2 rad on 0.25 m has an rms of 13 mm about its plane: noise of 12 mm leaves the plane nearly as good.
  CHECK_FALSE(pipe_bends(1.2, 0.012));
}

TEST_CASE("curved_checks__posts_and_corners_are_faceted_octagons_and_pipes_are_round") {
  CHECK(faceted_about_z(prism(4, 0.2)));
  CHECK(faceted_about_z(prism(3, 0.2)));
  CHECK_FALSE(faceted_about_z(prism(8, 0.2)));
  CHECK_FALSE(faceted_about_z(prism(100, 0.2)));
  std::vector<Vec3> corner = prism(4, 0.2);
  std::erase_if(corner, [](const Vec3& p) { return p.x < 0.19 && p.y < 0.19; });
  CHECK(faceted_about_z(corner));
  Scene scene;
  RandomStream random(4, 21);
  const Sphere ball{{0, 0, 0}, 0.5};
  add_ball(scene, 1, ball, -1, 1000, kCheckNoise_m, random);
  Task task;
  CHECK_FALSE(is_faceted(about(Curved(ball), scene.points), scene.points, task));
}

TEST_CASE("curved_checks__a_pipe_stands_out_of_free_air_and_not_of_clutter") {
  const Cylinder pipe{{1, 1, 1}, {0, 0, 1}, 0.25};
  // The layers one to two tolerances off the pipe hold 0.157 m3: 1 500 of its 3 000 points at 9 500 points a m3.
  for (const size_t clutter : {size_t{0}, size_t{3000}, size_t{24000}}) {
    Scene scene;
    RandomStream random(5, 21);
    add_pipe(scene, 1, {pipe, 2}, 3000, kCheckNoise_m, random);
    scene.outliers({0.5, 0.5, 0}, {1.5, 1.5, 2}, clutter, random);  // 2 m3
    MadeScene made(scene.points, all_primitives());
    const PointPool pool(made.scene, made.task);
    const Surface surface = curved_surface(made, scene.faces, 1, Curved(pipe));
    CHECK(stands_out(made.scene, pool, surface, local_points(made, surface), made.task) ==
          (clutter < 19000));
  }
}

TEST_CASE("curved_checks__clutter_on_the_side_that_was_not_seen_takes_nothing_from_half_a_pipe") {
  const Cylinder pipe{{1, 1, 1}, {0, 0, 1}, 0.25};
  Scene scene, all;
  RandomStream random(7, 21);
  add_pipe(scene, 1, {pipe, 2, std::numbers::pi}, 1500, kCheckNoise_m, random);
  all.outliers({0.5, 0.5, 0}, {1.5, 1.5, 2}, 40000, random);
  const Vec3 seen = across(pipe.direction)[1];
  for (const Vec3& p : all.points)
    if (dot(p - pipe.point, seen) < -0.05) scene.points.push_back(p);
  scene.faces.resize(scene.points.size(), 0);
  MadeScene made(scene.points, all_primitives());
  const PointPool pool(made.scene, made.task);
  const Surface half = curved_surface(made, scene.faces, 1, Curved(pipe));
  CHECK(stands_out(made.scene, pool, half, local_points(made, half), made.task));
}

TEST_CASE("curved_checks__the_band_of_a_cylinder_is_one_and_a_ball_is_none") {
  Scene scene;
  RandomStream random(6, 21);
  const Cylinder arch{{0, 0.15, 2}, {0, 1, 0}, 0.6};
  add_pipe(scene, 1, {arch, 0.3, std::numbers::pi}, 3000, 0.002, random);
  Task task;
  PrimitiveSetting setting;
  setting.robust = false;
  SphereFit fit;
  REQUIRE(fit_sphere(scene.points, setting, task, fit));
  Curved found;
  REQUIRE(better_as_cylinder(about(Curved(fit.sphere), scene.points), scene.points, setting, task,
                             found));
  REQUIRE(found.type == PrimitiveType::kCylinder);
  // Half a turn fixes the radius to some 3 sigma / sqrt(n) = 0.11 mm, a band of 0.3 m the axis to 10 sigma / sqrt(n).
  CHECK(std::fabs(found.radius - 0.6) < 4 * 1.1e-4);
  CHECK(std::fabs(dot(found.axis, arch.direction)) > std::cos(0.005));
  const Sphere whole{{1, 2, 3}, 0.6};
  for (const double least_cosine : {-1.0, 0.5}) {  // all of it, a cap of 60 degrees
    Scene ball;
    add_ball(ball, 1, whole, least_cosine, 3000, 0.002, random);
    const Surface round = about(Curved(whole), ball.points);
    Curved none;
    CHECK_FALSE(better_as_cylinder(round, ball.points, setting, task, none));
    CHECK_FALSE(none.exists());
  }
}
