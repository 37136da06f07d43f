// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "cloud/neighbourhoods.h"
#include "cloud/normals_parts.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

Vec3 normal_of(const Column& column, size_t i) {
  return {column.number(i, 0), column.number(i, 1), column.number(i, 2)};
}

TEST_CASE("quadric_normals__of_a_paraboloid_are_those_of_its_gradient") {
  std::vector<Vec3> points;
  for (const Vec3& p : random_points(900, 2, 4)) {
    const double x = p.x - 1, y = p.y - 1;
    points.push_back({x, y, 0.2 * x * x + 0.1 * x * y - 0.15 * y * y});
  }
  const Cloud cloud = cloud_of(points);
  Task task;
  const auto tree = cloud.octree(task);
  for (const double radius_m : {0.0, 0.3}) {
    const auto column = quadric_normals(*tree, 20, radius_m, task);
    REQUIRE(column->count() == points.size());
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec3& p = points[i];
      const Vec3 truth = normalized(Vec3{-0.4 * p.x - 0.1 * p.y, 0.3 * p.y - 0.1 * p.x, 1});
      const Vec3 n = normal_of(*column, i);
      REQUIRE(norm(n) == doctest::Approx(1).epsilon(1e-6));
      REQUIRE(norm(cross(n, truth)) < 5e-3);
    }
  }
}

// Summed by parts of the tree, they are those of the points one by one.
TEST_CASE("quadric_normals__of_balls_of_thousands_of_points_are_those_of_lists_of_them") {
  constexpr double kRadius_m = 1.2;
  std::vector<Vec3> points;
  RandomStream random(4, 1);
  for (const Vec3& p : random_points(5000, 3, 4))
    points.push_back(
        {652000 + p.x, 6861000 + p.y, std::sin(p.x) * std::cos(p.y) + 0.01 * random.normal()});
  const Cloud cloud = cloud_of(points);
  Task task;
  const auto tree = cloud.octree(task);
  const auto column = quadric_normals(*tree, 20, kRadius_m, task);
  std::vector<Neighbour> near;
  size_t large = 0;
  for (size_t position = 0; position < points.size(); position += 17) {
    const size_t i = tree->order()[position];
    tree->radius_positions(cloud.point(i), kRadius_m, near);
    Moments moments;
    moments.reference = tree->local(position);
    std::vector<Vec3> places, work;
    for (const Neighbour& n : near) {
      places.push_back(tree->local(n.index));
      moments.add(places.back());
    }
    PrincipalFrame frame;
    LocalQuadric fit;
    REQUIRE(principal_frame(moments, frame));
    REQUIRE(local_quadric(frame, places, moments.reference, work, fit));
    const Vec3 n = fit.quadric.normal(fit.x, fit.y);
    const Vec3 truth = normalized(frame.u * n.x + frame.v * n.y + frame.n * n.z);
    CHECK(norm(cross(normal_of(*column, i), truth)) < 1e-6);
    large += near.size() > 1024;
  }
  CHECK(large > 100);
}

TEST_CASE("quadric_normals__of_a_plane_are_its_own_also_where_no_quadric_is_fixed") {
  // Four points: a plane, but too few for a quadric.
  const Vec3 n = normalized(Vec3{1, -2, 3});
  const Vec3 u = normalized(cross(n, {0, 0, 1})), v = cross(n, u);
  const Cloud cloud = cloud_of({u, v, -u, -v});
  Task task;
  const auto column = quadric_normals(*cloud.octree(task), 16, 0, task);
  for (size_t i = 0; i < 4; ++i) CHECK(norm(cross(normal_of(*column, i), n)) < 1e-6);
}

TEST_CASE("quadric_normals__are_nan_where_neighbours_span_no_plane") {
  std::vector<Vec3> line;
  for (int i = 0; i < 30; ++i) line.push_back({0.25 * i, 0.5 * i, 1});
  Task task;
  const auto column = quadric_normals(*cloud_of(line).octree(task), 8, 0, task);
  for (size_t i = 0; i < line.size(); ++i) CHECK(std::isnan(column->number(i, 0)));
}

TEST_CASE("new_normal_column__is_three_floats_a_point_called_normal") {
  const auto column = new_normal_column(7);
  CHECK(column->info().name == "normal");
  CHECK(column->info().type == ElementType::kFloat32);
  CHECK(column->info().components == 3);
  CHECK(column->count() == 7);
}

}  // namespace
}  // namespace jalon
