// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/neighbourhoods.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

struct NoScratch {};

Moments moments_of(const std::vector<Vec3>& points) {
  Moments moments;
  for (const Vec3& p : points) moments.add(p);
  return moments;
}

TEST_CASE("neighbourhoods__by_radius_or_number_hold_the_points_that_brute_force_counts") {
  const auto points = random_points(800, 4, 1);
  Task task;
  const Cloud cloud = cloud_of(points);
  const auto tree = cloud.octree(task);
  std::vector<size_t> in_ball(points.size()), nearest(points.size());
  for_each_neighbourhood<NoScratch>(*tree, 5, 0.6, task, [&](const Neighbourhood& n, NoScratch&) {
    in_ball[tree->order()[n.point]] = n.neighbours.size();
    REQUIRE(n.squared.size() == n.neighbours.size());
  });
  for_each_neighbourhood<NoScratch>(*tree, 5, 0, task, [&](const Neighbourhood& n, NoScratch&) {
    nearest[tree->order()[n.point]] = n.neighbours.size();
    REQUIRE(n.neighbours[0] == n.point);
  });
  for (size_t i = 0; i < points.size(); ++i) {
    size_t count = 0;
    for (const Vec3& p : points) count += squared_norm(p - points[i]) <= 0.36;
    REQUIRE(in_ball[i] == count);
    REQUIRE(nearest[i] == 5);
  }
}

// So that the cost of a pile does not grow with its square.
TEST_CASE("neighbourhoods__of_points_that_coincide_are_told_to_repeat") {
  std::vector<Vec3> points = random_points(300, 4, 3);
  for (int i = 0; i < 700; ++i) points.push_back({2, 2, 2});
  Task task;
  const Cloud cloud = cloud_of(points);
  const auto tree = cloud.octree(task);
  struct Last {
    size_t point = 0;
    std::vector<uint32_t> neighbours;
  };
  Task::Hooks hooks;
  hooks.threads = 1;
  Task one(hooks);
  size_t visits = 0, anew = 0;
  for_each_neighbourhood<Last>(*tree, 5, 0.6, one, [&](const Neighbourhood& n, Last& last) {
    ++visits;
    anew += n.repeats ? 0 : 1;
    const std::vector<uint32_t> neighbours(n.neighbours.begin(), n.neighbours.end());
    if (n.repeats) {
      REQUIRE(neighbours == last.neighbours);
      REQUIRE(tree->local(n.point) == tree->local(last.point));
    }
    last = {n.point, neighbours};
  });
  CHECK(visits == 1000);
  // The pile once, and where chunks and what they hand on begin.
  CHECK(anew >= 301);
  CHECK(anew < 330);
}

TEST_CASE("neighbourhoods__of_a_cloud_smaller_than_k_are_the_whole_cloud") {
  Task task;
  const Cloud cloud = cloud_of(random_points(4, 1, 2));
  size_t visits = 0;
  for_each_neighbourhood<NoScratch>(*cloud.octree(task), 16, 0, task,
                                    [&](const Neighbourhood& n, NoScratch&) {
                                      CHECK(n.neighbours.size() == 4);
                                      ++visits;
                                    });
  CHECK(visits == 4);
}

TEST_CASE("principal_frame__of_a_turned_brick_has_its_axes_and_variances") {
  // Corners of a brick with half edges 3, 2, 1 along turned axes: variances 9, 4, 1.
  const Vec3 u = normalized(Vec3{1, 2, 2}), v = normalized(Vec3{2, 1, -2}), n = cross(u, v);
  std::vector<Vec3> points;
  for (const double a : {-3.0, 3.0})
    for (const double b : {-2.0, 2.0})
      for (const double c : {-1.0, 1.0}) points.push_back(Vec3{10, 20, 30} + u * a + v * b + n * c);
  PrincipalFrame frame;
  REQUIRE(principal_frame(moments_of(points), frame));
  CHECK(norm(frame.centre - Vec3{10, 20, 30}) < 1e-12);
  CHECK(std::abs(dot(frame.u, u)) == doctest::Approx(1).epsilon(1e-9));
  CHECK(std::abs(dot(frame.n, n)) == doctest::Approx(1).epsilon(1e-9));
  CHECK(norm(cross(frame.u, frame.v) - frame.n) < 1e-9);
  for (size_t i = 0; i < 3; ++i)
    CHECK(frame.eigenvalues[i] == doctest::Approx(std::array{1.0, 4.0, 9.0}[i]).epsilon(1e-9));
}

TEST_CASE("principal_frame__refuses_two_points_and_lines") {
  PrincipalFrame frame;
  CHECK_FALSE(principal_frame(moments_of({{0, 0, 0}, {1, 2, 3}}), frame));
  CHECK_FALSE(principal_frame(moments_of({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}}), frame));
  CHECK_FALSE(principal_frame(moments_of({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), frame));
}

TEST_CASE("local_quadric__gives_a_paraboloid_back_and_refuses_five_points") {
  PrincipalFrame frame;
  frame.centre = {5, 6, 7};
  frame.u = {1, 0, 0}, frame.v = {0, 1, 0}, frame.n = {0, 0, 1};
  std::vector<Vec3> points, work;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      points.push_back(frame.centre +
                       Vec3{0.1 * x, 0.1 * y, 0.01 * (2 * x * x - y * y + x * y) + 0.02 * x});
  LocalQuadric fit;
  REQUIRE(local_quadric(frame, points, frame.centre + Vec3{0.1, -0.2, 9}, work, fit));
  CHECK(fit.x == doctest::Approx(0.1).scale(0));
  CHECK(fit.y == doctest::Approx(-0.2).scale(0));
  CHECK(fit.quadric.a == doctest::Approx(2));
  CHECK(fit.quadric.b == doctest::Approx(0.2).scale(0));
  CHECK(fit.quadric.c == doctest::Approx(1));
  CHECK(fit.quadric.e == doctest::Approx(-1));
  points.resize(5);
  CHECK_FALSE(local_quadric(frame, points, frame.centre, work, fit));
}

}  // namespace
}  // namespace jalon
