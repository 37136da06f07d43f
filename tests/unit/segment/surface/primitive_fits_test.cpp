// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Spheres, cylinders and circles of listed points of a cloud, against shapes made by hand.
#include <doctest/doctest.h>

#include <cmath>

#include "segment/surface/primitive_fits.h"
#include "unit/compare/refusal.h"
#include "unit/segment/curved_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const Vec3 kFitGrid{652000.25, 6861000.5, 40};

}  // namespace

TEST_CASE("listed_points__those_named_in_their_order_from_a_whole_metre_near_them") {
  const CloudPtr cloud = cloud_of({{0, 0, 0}, {1, 2, 3}, {-1, 0.5, 2}, {4, 4, 4}}, kFitGrid);
  Task task;
  const std::vector<uint64_t> chosen{3, 1, 3};
  const PointList list = listed_points(*cloud, chosen, task);
  REQUIRE(list.points.size() == 3);
  for (size_t i = 0; i < 3; ++i) CHECK(list.origin + list.points[i] == cloud->point(chosen[i]));
  for (int k = 0; k < 3; ++k) CHECK(list.origin[k] == std::floor(cloud->point(3)[k]));
  CHECK(listed_points(*cloud, {}, task).points.size() == 4);
  CHECK(listed_points(Cloud(), {}, task).points.empty());
  CHECK(refuses(
      [&] {
        listed_points(*cloud, std::vector<uint64_t>{0, 4}, task);
      },
      Status::kInvalidArgument, "point 4; the cloud has 4"));
}

TEST_CASE("listed_normals__from_the_field_where_there_is_one_else_from_the_neighbours") {
  Scene wall;
  RandomStream random(1, 31);
  wall.rectangle(1, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 400, 0.0005, random);
  Cloud cloud = *cloud_of(wall.points);
  Task task;
  const std::vector<uint64_t> chosen{7, 200};
  for (const Vec3& n : listed_normals(cloud, chosen, 20, task)) CHECK(std::fabs(n.y) > 0.999);
  std::vector<float> field(1200, 0);
  field[3 * 7] = 5;  // longer than a unit vector
  field[3 * 200 + 2] = -0.5f;
  cloud.fields.set(make_column<float>({"normal", ElementType::kFloat32, 3}, field));
  const auto taken = listed_normals(cloud, chosen, 20, task);
  REQUIRE(taken.size() == 2);
  CHECK(taken[0] == Vec3{1, 0, 0});
  CHECK(taken[1] == Vec3{0, 0, -1});
  const auto tree = cloud.octree(task);
  CHECK(std::isnan(normal_near(cloud, *tree, {0, 0, 0}, 2).x));  // two points have no plane
}

TEST_CASE("describe_curved__area_and_extents_of_a_pipe_and_a_ball") {
  RandomStream random(2, 31);
  Scene pipe, ball;
  Segment tube, globe;
  tube.type = PrimitiveType::kCylinder;
  tube.cylinder.cylinder = {{1, 2, 3}, normalized(Vec3{1, 0.2, 0.5}), 0.4};
  globe.type = PrimitiveType::kSphere;
  globe.sphere.sphere = {{1, 2, 3}, 0.8};
  const double turn_rad = 4;
  add_pipe(pipe, 1, {tube.cylinder.cylinder, 2.5, turn_rad}, 20000, 0, random);
  add_ball(ball, 1, globe.sphere.sphere, 0, 20000, 0, random);  // half of it
  Task task;
  describe_curved(pipe.points, 0.04, tube, task);
  describe_curved(ball.points, 0.04, globe, task);
  // Pixels that the border crosses count whole: half a pixel along 7 m, 4 %; 8 points a pixel leave none empty.
  CHECK(tube.area_m2 == doctest::Approx(0.4 * turn_rad * 2.5).epsilon(0.05).scale(0));
  CHECK(globe.area_m2 == doctest::Approx(kFullTurn_rad * 0.64).epsilon(0.05).scale(0));
  CHECK(tube.length_u_m ==
        doctest::Approx(2.5).epsilon(0.002).scale(0));  // ends of 20 000 random points
  CHECK(tube.length_v_m == doctest::Approx(0.4 * turn_rad).epsilon(0.002).scale(0));
  CHECK(std::isnan(globe.length_u_m));
}

TEST_CASE("primitive_segments__shapes_of_noisy_points_in_national_coordinates") {
  RandomStream random(3, 31);
  Scene scene;
  const Sphere ball{{3, 1, 1}, 0.5};
  const Cylinder column{{1, 1, 1}, normalized(Vec3{0.1, -0.1, 1}), 0.25};
  add_ball(scene, 1, ball, -1, 2000, 0.002, random);
  add_pipe(scene, 2, {column, 2}, 2000, 0.002, random);
  scene.outliers({2, 2, 4}, {3, 3, 6}, 40, random);  // above the column and beside it
  const CloudPtr cloud = cloud_of(scene.points, kFitGrid);
  Task task;
  std::vector<uint64_t> of_ball, of_column;
  for (uint64_t i = 0; i < 2040; ++i) {
    if (i < 2000) of_ball.push_back(i);
    of_column.push_back(2000 + i);
  }
  const Segment sphere = sphere_segment(*cloud, of_ball, {}, task);
  const double sigma = 0.002 / std::sqrt(2000.0);  // of a radius; of a centre sqrt(3) of it an axis
  CHECK(norm(sphere.sphere.sphere.centre - kFitGrid - ball.centre) < 10 * sigma);
  CHECK(std::fabs(sphere.sphere.sphere.radius - 0.5) < 5 * sigma);
  for (const bool told : {false, true}) {
    const Segment found =
        cylinder_segment(*cloud, of_column, told ? &column.direction : nullptr, {}, task);
    CHECK(std::fabs(found.cylinder.cylinder.radius - 0.25) < 5 * sigma);
    CHECK(column.axis_distance(found.cylinder.cylinder.point - kFitGrid) < 10 * sigma);
    CHECK(dot(found.cylinder.cylinder.direction, column.direction) > 1 - 1e-6);
    CHECK(found.length_u_m == doctest::Approx(2).epsilon(0.01).scale(0));
  }
}

TEST_CASE("circle_table__centre_normal_and_radius_of_a_leaning_ring") {
  const Vec3 axis = normalized(Vec3{0.2, 0.3, 1}), centre{4, 5, 6};
  const auto e = across(axis);
  RandomStream random(4, 31);
  std::vector<Vec3> ring;
  for (int i = 0; i < 500; ++i) {
    const double a = kFullTurn_rad * random.uniform(), r = 0.7 + 0.001 * random.normal();
    ring.push_back(centre + r * (std::cos(a) * e[0] + std::sin(a) * e[1]));
  }
  Task task;
  const FieldTable t = circle_table(*cloud_of(ring, kFitGrid), {}, {}, task);
  const Column& middle = t.require("centre");
  const Column& normal = t.require("normal");
  const Vec3 found{middle.number(0, 0), middle.number(0, 1), middle.number(0, 2)};
  const double sigma = 0.001 / std::sqrt(500.0);
  CHECK(norm(found - kFitGrid - centre) < 7 * sigma);  // sqrt(2) of it on two axes
  CHECK(std::fabs(dot({normal.number(0, 0), normal.number(0, 1), normal.number(0, 2)}, axis)) >
        1 - 1e-9);  // all points are in the plane
  CHECK(std::fabs(t.require("radius").number(0) - 0.7) < 5 * sigma);
  CHECK(t.require("sigma").number(0) ==
        doctest::Approx(0.001).epsilon(0.13).scale(0));  // 4 / sqrt(2 n)
  CHECK(t.require("covariance").number(0, 15) ==
        doctest::Approx(sigma * sigma).epsilon(0.3).scale(0));
}

TEST_CASE("primitive_segments__too_few_flat_or_limited_points_are_named") {
  Task task;
  std::vector<Vec3> sheet;
  for (int i = 0; i < 100; ++i) sheet.push_back({0.1 * (i % 10), 0.1 * (i / 10), 0});
  const CloudPtr flat = cloud_of(sheet), three = cloud_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Vec3 none{}, up{0, 0, 1};
  CHECK(refuses([&] { sphere_segment(*three, {}, {}, task); }, Status::kInsufficientData,
                "a sphere needs 4"));
  CHECK(refuses([&] { cylinder_segment(*three, {}, nullptr, {}, task); }, Status::kInsufficientData,
                "a cylinder needs 5"));
  CHECK(refuses([&] { cylinder_segment(*flat, {}, &none, {}, task); }, Status::kInvalidArgument,
                "direction"));
  CHECK(refuses([&] { sphere_segment(*flat, {}, {}, task); }, Status::kDegenerate, "no sphere"));
  const CloudPtr line = cloud_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  CHECK(refuses([&] { circle_table(*line, {}, {}, task); }, Status::kDegenerate, "no circle"));
  CHECK(refuses([&] { cylinder_segment(*line, {}, &up, {}, task); }, Status::kDegenerate,
                "no cylinder"));
  PrimitiveFitSettings narrow;
  narrow.fit.max_radius_m = 0.3;
  Scene ball;
  RandomStream random(5, 31);
  add_ball(ball, 1, {{0, 0, 0}, 0.5}, -1, 200, 0.001, random);
  CHECK(refuses([&] { sphere_segment(*cloud_of(ball.points), {}, narrow, task); },
                Status::kDegenerate, "0.3"));
}
