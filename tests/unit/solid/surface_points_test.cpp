// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/surface_points.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "unit/solid/brute_force.h"
#include "unit/solid/cube.h"
#include "unit/solid/status.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Points with their octree.
struct Points {
  std::vector<double> xyz;
  std::shared_ptr<const Octree> tree;

  Points(const std::vector<Vec3>& points, Task& task) {
    Box3 box;
    for (const Vec3& p : points) {
      box.add(p);
      xyz.insert(xyz.end(), {p.x, p.y, p.z});
    }
    tree = Octree::build(xyz, enclosing_cube(box), task);
  }
  Vec3 at(size_t i) const { return {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}; }
};

}  // namespace

TEST_CASE("clearance_of_points__inside_near_and_far_of_a_cube") {
  Task task;
  const PartSurface cube = cube_surface({0, 0, 0}, 2, task);
  const Points points({{9, 9, 9}, {1, 1, 2.25}, {1, 1, 0.75}, {3, 1, 1}, {0.25, 1, 1}}, task);
  const PointClearance c = clearance_of_points(cube, *points.tree, points.xyz, 0.5, task);
  CHECK(c.inside == 2);
  REQUIRE(c.near.size() == 3);
  CHECK(c.near[0].point == 1);
  CHECK(c.near[0].distance_m == doctest::Approx(0.25));
  CHECK(norm(c.near[0].foot - Vec3{1, 1, 2}) < 1e-12);
  CHECK(c.near[1].point == 2);
  CHECK(c.near[1].distance_m == doctest::Approx(-0.75));
  CHECK(c.near[2].point == 4);
  CHECK(c.least.point == 2);
  CHECK(c.least.distance_m == doctest::Approx(-0.75));
}

TEST_CASE("clearance_of_points__behind_an_open_sheet_is_not_inside") {
  Task task;
  const PartSurface sheet({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}, task);
  const Points points({{1, 1, -0.5}, {1, 1, 0.25}}, task);
  const PointClearance c = clearance_of_points(sheet, *points.tree, points.xyz, 0, task);
  CHECK(c.inside == 0);
  CHECK(c.near.empty());
  CHECK(c.least.point == 1);
  CHECK(c.least.distance_m == doctest::Approx(0.25));
}

TEST_CASE("clearance_of_points__of_a_crowd_equals_every_point_by_itself") {
  Task one(threads(1)), seven(threads(7));
  const PartSurface cube = cube_surface({2, 2, 2}, 2, one);
  const brute::Distance truth = brute::box({2, 2, 2});
  RandomStream random(51, 0);
  std::vector<Vec3> places(3000);
  for (Vec3& p : places) p = brute::any_vector(random, 3) + Vec3{3, 3, 3};
  const Points points(places, one);
  const PointClearance c = clearance_of_points(cube, *points.tree, points.xyz, 0.3, one),
                       d = clearance_of_points(cube, *points.tree, points.xyz, 0.3, seven);
  std::vector<uint32_t> expected;
  uint64_t inside = 0;
  for (uint32_t i = 0; i < places.size(); ++i) {
    const double s = truth(points.at(i) - Vec3{3, 3, 3});
    if (s <= 0.3) expected.push_back(i);
    inside += s < 0;
  }
  REQUIRE(c.near.size() == expected.size());
  REQUIRE(d.near.size() == expected.size());
  CHECK(c.inside == inside);
  for (size_t i = 0; i < expected.size(); ++i) {
    CHECK(c.near[i].point == expected[i]);
    CHECK(c.near[i].distance_m ==
          doctest::Approx(truth(points.at(expected[i]) - Vec3{3, 3, 3})).epsilon(1e-9));
    CHECK(c.near[i].distance_m == d.near[i].distance_m);
  }
}
