// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/triangles/triangle_growth.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/segment/made_scene.h"
#include "unit/segment/ramp.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("triangle_growth__grows_three_regions_on_the_ramp") {
  const Scene scene = ramp(0.005, 2);
  MadeScene made(scene.points);
  const Octree& tree = *made.scene.tree;
  LocalMesh mesh = local_mesh(tree, {.k = 16}, made.task);
  const TriangleRegions regions =
      grow_triangles(tree, std::move(mesh), {0.025, 0.17, 20}, made.task);
  REQUIRE(regions.planes.size() == 3);
  for (const Plane& plane : regions.planes) CHECK(std::fabs(plane.normal.y) < 0.01);
  CHECK(std::count(regions.labels.begin(), regions.labels.end(), 0u) < 16);
}

TEST_CASE("triangle_growth__keeps_no_region_below_the_least") {
  const Scene scene = ramp(0, 2);
  MadeScene made(scene.points);
  const Octree& tree = *made.scene.tree;
  LocalMesh mesh = local_mesh(tree, {.k = 16}, made.task);
  const TriangleRegions regions =
      grow_triangles(tree, std::move(mesh), {0.025, 0.17, 200}, made.task);
  CHECK(regions.planes.size() == 2);  // the ramp has 144 to 176 points
}
