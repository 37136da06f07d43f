// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The points of a cloud near the edges of a plane, against a look at all of them.
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "base/random.h"
#include "geometry/polygon2.h"
#include "modelling/plane/near_points.h"
#include "unit/modelling/walls.h"

using namespace walls;

namespace {

constexpr NearSetting kNearSetting{0.2, 0.3, 0.01};

/// Two parallel walls 5 mm apart, and points anywhere about them.
Segmentation two_walls_and_clutter() {
  RandomStream random(3, 6);
  std::vector<Vec3> wall, twin, clutter;
  for (int i = 0; i < 1500; ++i) {
    wall.push_back({4 * random.uniform(), 0, 3 * random.uniform()});
    twin.push_back({4 * random.uniform(), 0.005, 3 * random.uniform()});
    clutter.push_back({5 * random.uniform() - 0.5, 2 * random.uniform() - 1, 4 * random.uniform()});
  }
  return segmentation_of({wall, twin, clutter});
}

}  // namespace

TEST_CASE("near_points__are_all_within_reach_of_the_rings_each_once") {
  const Segmentation segmentation = two_walls_and_clutter();
  Task task;
  const auto tree = segmentation.cloud->octree(task);
  const PlaneFrame frame = plane_frame({{0, -1, 0}, 0}, {0, 0, 0}, {1, 0, 0});
  const std::vector<std::vector<Vec2>> rings{{{0, 0}, {4, 0}, {4, 3}, {0, 3}},
                                             {{1, 1}, {1, 2}, {2, 2}}};
  const std::vector<uint8_t> parallel{0, 1, 0};
  const NearPoints near =
      points_near(segmentation, *tree, frame, rings, parallel, kNearSetting, task);
  REQUIRE(near.heights_m.size() == near.points.size());
  REQUIRE(near.on_plane.size() == near.points.size());
  std::multiset<std::pair<double, double>> found;
  size_t twins = 0, own = 0;
  for (size_t i = 0; i < near.points.size(); ++i) {
    found.insert({near.points[i].u, near.points[i].v});
    const double h = near.heights_m[i];
    CHECK(std::fabs(h) <= kNearSetting.depth_m + 1e-6);
    if (std::fabs(h) > kNearSetting.window_m) CHECK(near.on_plane[i] == 0);
    if (std::fabs(h + 0.005) < 1e-5 && near.on_plane[i] == 0) ++twins;  // behind the wall
    if (h == 0) CHECK(near.on_plane[i] == 1);
    own += h == 0;
  }
  CHECK(twins > 100);
  CHECK(own > 100);
  const auto labels = segmentation.labels->values<uint32_t>();
  size_t expected = 0;
  for (size_t i = 0; i < segmentation.cloud->size(); ++i) {
    const Vec3 p = segmentation.cloud->point(i);
    const Vec2 q = frame.project(p);
    const double distance = std::min(border_distance(rings[0], q), border_distance(rings[1], q));
    const size_t count = found.count({q.u, q.v});
    CHECK(count <= 1);
    if (distance > kNearSetting.reach_m || std::fabs(p.y) > kNearSetting.depth_m) continue;
    CHECK(count == 1);
    ++expected;
  }
  CHECK(expected > 1000);
  CHECK(labels.size() == segmentation.cloud->size());
}

TEST_CASE("near_points__of_no_rings_are_none") {
  const Segmentation segmentation = two_walls_and_clutter();
  Task task;
  const auto tree = segmentation.cloud->octree(task);
  const PlaneFrame frame = plane_frame({{0, -1, 0}, 0}, {0, 0, 0}, {1, 0, 0});
  const std::vector<uint8_t> parallel{0, 1, 0};
  CHECK(points_near(segmentation, *tree, frame, {}, parallel, kNearSetting, task).points.empty());
  // Nor those of a ring where no point is.
  const std::vector<std::vector<Vec2>> far{{{100, 100}, {101, 100}, {101, 101}}};
  CHECK(points_near(segmentation, *tree, frame, far, parallel, kNearSetting, task).points.empty());
}
