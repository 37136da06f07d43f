// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The direction of the main facade from normals whose directions are made by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/numbers.h"
#include "segment/ransac/orientation_pass.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kTurnDegree = std::numbers::pi / 180;

// A scene of points whose normals are given; where the points lie has no say.
struct NormalsOnly {
  CloudPtr cloud;
  Task task;
  SegmentScene scene;

  explicit NormalsOnly(const std::vector<Vec3>& normals)
      : cloud(random_cloud(normals.size())), scene(indexed_scene(*cloud, {}, task)) {
    for (size_t p = 0; p < normals.size(); ++p)
      for (int k = 0; k < 3; ++k)
        scene.normals[3 * p + static_cast<size_t>(k)] = static_cast<float>(normals[p][k]);
  }
  static CloudPtr random_cloud(size_t n) {
    RandomStream random(1, 25);
    std::vector<Vec3> points(n);
    for (Vec3& p : points) p = {random.uniform(), random.uniform(), random.uniform()};
    return cloud_of(points);
  }
};

// Normal of this azimuth, on either side, leaning by so much.
Vec3 upright(double azimuth_rad, double lean_rad, RandomStream& random) {
  const double side = random.uniform() < 0.5 ? -1 : 1, flat = side * std::cos(lean_rad);
  return {flat * std::cos(azimuth_rad), flat * std::sin(azimuth_rad), std::sin(lean_rad)};
}

}  // namespace

TEST_CASE("facade_axes__the_busiest_upright_direction_wherever_it_points") {
  for (const double degrees : {0.0, 0.4, 37.2, 90.0, 133.7, 179.5, 179.99}) {
    CAPTURE(degrees);
    const double azimuth = degrees * kTurnDegree;
    RandomStream random(2, static_cast<uint64_t>(degrees));
    std::vector<Vec3> normals;
    for (int i = 0; i < 2000; ++i) {  // the facade, 1 degree of noise, walls that lean by 4 degrees
      const double turn = kTurnDegree * random.normal(), lean = 2 * kTurnDegree * random.normal();
      normals.push_back(upright(azimuth + turn, lean, random));
    }
    for (int i = 0; i < 1200; ++i)  // its sides
      normals.push_back(upright(azimuth + (90 + random.normal()) * kTurnDegree, 0, random));
    for (int i = 0; i < 4000; ++i)  // the ground, and roofs of the same azimuth but 45 degrees
      normals.push_back(i % 2 == 0 ? Vec3{0, 0, 1}
                                   : upright(azimuth + 0.5, 45 * kTurnDegree, random));
    for (int i = 0; i < 300; ++i) normals.push_back({kNaN, kNaN, kNaN});
    NormalsOnly made(normals);
    const FacadeAxes axes = facade_axes(made.scene, made.task);
    const Vec3 truth{std::cos(azimuth), std::sin(azimuth), 0};
    // 1 degree cut at 2 has 0.88; over sqrt(1900) points 0.02 degrees; five of these.
    CHECK(std::fabs(dot(axes.across, truth)) > std::cos(0.1 * kTurnDegree));
    CHECK(std::fabs(dot(axes.along, truth)) < std::sin(0.1 * kTurnDegree));
  }
}

TEST_CASE("facade_axes__more_points_decide_between_two_walls") {
  for (const bool first : {true, false}) {
    RandomStream random(3, 25);
    std::vector<Vec3> normals;
    for (int i = 0; i < 1000; ++i)
      normals.push_back(upright((i < (first ? 600 : 400) ? 20 : 110) * kTurnDegree, 0, random));
    NormalsOnly made(normals);
    const Vec3 across = facade_axes(made.scene, made.task).across;
    const double azimuth = (first ? 20 : 110) * kTurnDegree;
    CHECK(std::fabs(dot(across, Vec3{std::cos(azimuth), std::sin(azimuth), 0})) >
          1 - 1e-9);  // normals are floats
  }
}

TEST_CASE("facade_axes__a_wall_whose_normals_spread_over_degrees_counts_as_one") {
  RandomStream random(4, 25);
  std::vector<Vec3> normals;
  for (int i = 0; i < 2100; ++i)  // no two degrees of the first have as many as one of the second
    normals.push_back(
        upright((i < 1200 ? 30 + 2.8 * random.uniform() : 120.5) * kTurnDegree, 0, random));
  NormalsOnly made(normals);
  const Vec3 across = facade_axes(made.scene, made.task).across;
  const double azimuth = 31.4 * kTurnDegree;
  // 2.8 degrees / sqrt(12) over sqrt(1200): 0.024 degrees; five of these.
  CHECK(std::fabs(dot(across, Vec3{std::cos(azimuth), std::sin(azimuth), 0})) >
        std::cos(0.12 * kTurnDegree));
}

TEST_CASE("facade_axes__without_upright_normals_still_horizontal_unit_axes") {
  for (const Vec3& normal : {Vec3{0, 0, 1}, Vec3{kNaN, kNaN, kNaN}, Vec3{0.6, 0, 0.8}}) {
    NormalsOnly made(std::vector<Vec3>(100, normal));
    const FacadeAxes axes = facade_axes(made.scene, made.task);
    CHECK(axes.across.z == 0);
    CHECK(norm(axes.across) == doctest::Approx(1));
    CHECK(norm(cross(axes.across, axes.along) - Vec3{0, 0, 1}) < 1e-12);
  }
}
