// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/plane_match.h"

#include <doctest/doctest.h>

#include "unit/registration/coarse_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

CoarsePlane plane_at(const Vec3& normal, double offset, size_t cells) {
  return {{normalized(normal), offset}, cells};
}

std::vector<CoarsePlane> moved(const std::vector<CoarsePlane>& planes, const Transform& by) {
  std::vector<CoarsePlane> out;
  for (const CoarsePlane& p : planes) {
    const Vec3 n = by.direction(p.plane.normal);
    out.push_back({{n, dot(n, by.point(p.plane.normal * p.plane.offset))}, p.cells});
  }
  return out;
}

double turn_between(const Transform& a, const Transform& b) {
  return norm(rotation_vector(a * inverse(b)));
}

Transform linear(Transform t) {
  t.m[3] = t.m[7] = t.m[11] = 0;
  return t;
}

// Three planes at unlike angles: only half turns lay their lines on themselves.
std::vector<CoarsePlane> skew() {
  return {plane_at({1, 0, 0}, 2, 300), plane_at({1, 2, 0}, 1, 200), plane_at({1, 1, 3}, 4, 100)};
}

}  // namespace

TEST_CASE("plane_rotations__hold_the_true_one_and_are_rotations_apart_from_each_other") {
  for (uint64_t draw = 0; draw < 5; ++draw) {
    const Transform T_reference_moving = random_start(draw, true);
    const auto reference = moved(skew(), T_reference_moving), moving = skew();
    Task task;
    const auto turns = plane_rotations({reference, moving, false}, 400, task);
    double nearest = 10;
    for (size_t i = 0; i < turns.size(); ++i) {
      CHECK(turns[i].determinant() == doctest::Approx(1));
      CHECK(norm(turns[i].translation()) == 0);
      nearest = std::min(nearest, turn_between(turns[i], linear(T_reference_moving)));
      for (size_t k = 0; k < i; ++k) CHECK(turn_between(turns[i], turns[k]) > 0.0999);
    }
    CHECK(nearest < 1e-6);
    CHECK(plane_rotations({reference, moving, false}, 2, task).size() == 2);
  }
}

TEST_CASE("plane_rotations__that_lay_all_planes_on_parallel_ones_come_first") {
  const Transform T_reference_moving = random_start(7, true);
  const auto reference = moved(skew(), T_reference_moving), moving = skew();
  Task task;
  const auto turns = plane_rotations({reference, moving, false}, 400, task);
  REQUIRE_FALSE(turns.empty());
  for (size_t i = 0; i < 3; ++i)
    CHECK(std::abs(dot(turns[0].direction(moving[i].plane.normal), reference[i].plane.normal)) >
          kParallel);
}

TEST_CASE("plane_rotations__of_level_clouds_turn_about_the_vertical_alone") {
  const Transform T_reference_moving = random_start(4);
  const auto reference = moved(skew(), T_reference_moving), moving = skew();
  Task task;
  const auto turns = plane_rotations({reference, moving, true}, 400, task);
  double nearest = 10;
  for (const Transform& turn : turns) {
    CHECK(turn.m[10] == doctest::Approx(1));
    nearest = std::min(nearest, turn_between(turn, linear(T_reference_moving)));
  }
  CHECK(nearest < 1e-6);
  CHECK(plane_rotations({reference, {}, true}, 400, task).empty());
}

TEST_CASE("poses_of_largest__lay_the_largest_planes_and_the_centroids_on_each_other") {
  const auto reference = moved(skew(), random_start(9, true)), moving = skew();
  CoarseSurface a, b;
  a.centroid = {5, 6, 7};
  b.centroid = {-1, 0, 2};
  const auto poses = poses_of_largest({reference, moving, false}, a, b);
  REQUIRE(poses.size() == 8);
  for (size_t i = 0; i < 8; ++i) {
    CHECK(norm(poses[i].point(b.centroid) - a.centroid) < 1e-9);
    CHECK(norm(cross(poses[i].direction(moving[0].plane.normal), reference[0].plane.normal)) <
          1e-9);
    for (size_t k = 0; k < i; ++k) CHECK(turn_between(poses[i], poses[k]) > 1.5);
  }
  CHECK(poses_of_largest({reference, {}, false}, a, b).empty());
}
