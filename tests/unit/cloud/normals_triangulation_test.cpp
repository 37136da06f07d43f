// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "cloud/normals_parts.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

/// Of each point the sine of the angle between its normal and the true one.
std::vector<double> sines(const std::vector<Vec3>& points, const std::vector<Vec3>& truth) {
  Task task;
  const Cloud cloud = cloud_of(points);
  const auto column = triangulation_normals(*cloud.octree(task), task);
  std::vector<double> out;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 n{column->number(i, 0), column->number(i, 1), column->number(i, 2)};
    CHECK(norm(n) == doctest::Approx(1).epsilon(1e-6));
    out.push_back(norm(cross(n, truth[i])));
  }
  return out;
}

TEST_CASE("triangulation_normals__of_a_turned_plane_are_its_normal") {
  const Vec3 n = normalized(Vec3{1, 2, -3});
  const Vec3 u = normalized(cross(n, {0, 0, 1})), v = cross(n, u);
  std::vector<Vec3> points;
  for (const Vec3& p : random_points(2000, 6, 5)) points.push_back(u * p.x + v * p.y);
  const auto off = sines(points, std::vector<Vec3>(points.size(), n));
  CHECK(*std::max_element(off.begin(), off.end()) < 1e-4);
}

TEST_CASE("triangulation_normals__of_a_dense_sphere_are_its_radii_to_some_degrees") {
  const auto points = sphere(6000);
  auto off = sines(points, points);
  std::sort(off.begin(), off.end());
  CHECK(off[off.size() / 2] < 0.05);
  CHECK(off[off.size() * 9 / 10] < 0.15);
}

TEST_CASE("triangulation_normals__duplicates_get_the_normal_of_their_plane") {
  std::vector<Vec3> points;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      for (int copy = 0; copy < 2; ++copy) points.push_back({0.25 * x, 0.25 * y, 1});
  const auto off = sines(points, std::vector<Vec3>(points.size(), Vec3{0, 0, 1}));
  CHECK(*std::max_element(off.begin(), off.end()) < 1e-6);
}

TEST_CASE("triangulation_normals__are_nan_on_a_line_and_the_same_for_any_threads") {
  std::vector<Vec3> line;
  for (int i = 0; i < 50; ++i) line.push_back({0.5 * i, 0.25 * i, 2});
  Task one(threads(1)), four(threads(4));
  const Cloud thin = cloud_of(line);
  const auto none = triangulation_normals(*thin.octree(one), one);
  for (size_t i = 0; i < line.size(); ++i) CHECK(std::isnan(none->number(i, 0)));
  const Cloud cloud = cloud_of(sphere(20000));
  const auto tree = cloud.octree(one);
  const auto a = triangulation_normals(*tree, one), b = triangulation_normals(*tree, four);
  CHECK(std::memcmp(a->raw(), b->raw(), a->bytes()) == 0);
}

}  // namespace
}  // namespace jalon
