// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/facade_plane.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

constexpr double kNoise_m = 0.003, kTolerance_m = 0.02, kUpright_rad = 0.05;

/// A wall 10 m wide and 6 m high in the plane y = lean * z, seen over 5 m of ground before it, at -y.
std::vector<Vec3> wall_and_ground(double lean, uint64_t seed = 1) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 4000; ++i) {
    const double x = 10 * random.uniform(), z = 6 * random.uniform();
    points.push_back({x, lean * z + kNoise_m * random.normal(), z});
  }
  for (int i = 0; i < 1500; ++i) {
    const double x = 10 * random.uniform(), y = -5 * random.uniform();
    points.push_back({x, y, kNoise_m * random.normal()});
  }
  return points;
}

FacadePlane found(const std::vector<Vec3>& points, const Viewpoint& viewpoint = {},
                  unsigned thread_count = 2) {
  Task task(threads(thread_count));
  return find_facade_plane(cloud_of(points), kTolerance_m, kUpright_rad, viewpoint, 1, task);
}

TEST_CASE("facade_plane__is_that_of_the_wall_and_faces_the_ground_before_it") {
  for (const Vec3& at : {Vec3{}, kFar}) {
    const FacadePlane facade = found(shifted(wall_and_ground(0), at));
    CHECK(norm(facade.plane.normal - Vec3{0, -1, 0}) < 1e-3);
    for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{10, 0, 0}, Vec3{10, 0, 6}, Vec3{0, 0, 6}})
      CHECK(std::abs(facade.plane.distance(corner + at - facade.origin)) < 1e-3);
    CHECK(facade.along.z == 0);
    CHECK(std::abs(dot(facade.along, facade.plane.normal)) < 1e-12);
    CHECK(facade.up.z > 0.999);
    CHECK(norm(facade.up) == doctest::Approx(1));
  }
}

TEST_CASE("facade_plane__a_known_viewpoint_decides_the_side_against_the_points") {
  const auto points = wall_and_ground(0);
  for (const double y : {-20.0, 20.0}) {
    const FacadePlane facade = found(points, {true, {5, y, 2}});
    CHECK(facade.plane.distance(Vec3{5, y, 2} - facade.origin) > 19);
  }
}

TEST_CASE("facade_plane__leans_as_the_wall_does_up_to_the_tolerance") {
  const FacadePlane little = found(wall_and_ground(0.03));
  CHECK(std::asin(std::abs(little.plane.normal.z)) == doctest::Approx(0.03).scale(0).epsilon(0.02));
  CHECK(std::abs(found(wall_and_ground(0.2)).plane.normal.z) <= std::sin(kUpright_rad));
}

TEST_CASE("ground__is_the_level_plane_at_the_foot_and_none_where_there_is_only_a_wall") {
  Task task;
  auto points = wall_and_ground(0);
  const Cloud cloud = cloud_of(points);
  const FacadePlane facade = found(points);
  GroundPlane ground;
  REQUIRE(find_ground(cloud, facade, kTolerance_m, 1, task, ground));
  CHECK(norm(ground.plane.normal - Vec3{0, 0, 1}) < 2e-3);
  // 1500 points: 0.08 mm, of which five. The lower half of them would lie 0.8 noises too low.
  CHECK(std::abs(ground.plane.distance(Vec3{5, -2.5, 0} - facade.origin)) < 0.0004);
  points.resize(4000);
  CHECK_FALSE(find_ground(cloud_of(points), found(points), kTolerance_m, 1, task, ground));
}

TEST_CASE("facade_plane__refuses_poles_and_too_few_points_and_is_the_same_for_any_threads") {
  CHECK(status_of([] { found({{0, 0, 0}, {1, 0, 0}}); }) == Status::kInsufficientData);
  std::vector<Vec3> pole;
  for (int i = 0; i < 100; ++i) pole.push_back({1, 2, 0.1 * i});
  CHECK(status_of([&] { found(pole); }) == Status::kDegenerate);
  const auto points = wall_and_ground(0.01);
  const FacadePlane one = found(points, {}, 1), four = found(points, {}, 4);
  CHECK(one.plane.normal == four.plane.normal);
  CHECK(one.plane.offset == four.plane.offset);
}

}  // namespace
}  // namespace jalon
