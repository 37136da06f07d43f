// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/verdict/sights.h"

#include <doctest/doctest.h>

#include "unit/registration/verdict/judged_rooms.h"

using namespace jalon;
using namespace jalon::test;

namespace {

JudgedCloud judged(const Cloud& cloud, const SurfacePlanes& surface) {
  Task task;
  return judged_cloud(cloud, surface, {}, task);
}

}  // namespace

TEST_CASE("judged_cloud__finds_the_one_station_of_a_scan_without_stations") {
  const auto scan = judged_scan(furnished(5, 5), 0, 5);
  REQUIRE(scan->judged.sights.size() == 1);
  CHECK(norm(scan->judged.sights[0].station() - scan->station) < 0.5);
  for (const Surfel& surfel : scan->judged.surfels) CHECK(surfel.sight == 0);
}

TEST_CASE("judged_cloud__takes_the_stations_that_the_cloud_has") {
  const auto scan = judged_scan(furnished(5, 5), 0, 5);
  Cloud known = *scan->cloud;
  Station station;
  station.has_pose = true;
  station.pose.m[3] = 1;
  station.count = known.size() / 2;
  known.stations.push_back(station);
  const JudgedCloud judged_known = judged(known, scan->surface);
  REQUIRE(judged_known.sights.size() == 1);
  CHECK(norm(judged_known.sights[0].station() -
             (Vec3{1, 0, 0} - scan->surface.tree->cube().origin)) < 1e-9);
  size_t own = 0, other = 0;
  for (const Surfel& surfel : judged_known.surfels) {
    const bool is_first = scan->surface.tree->order()[surfel.position] < station.count;
    CHECK(surfel.sight == (is_first ? 0 : -1));
    (is_first ? own : other) += 1;
  }
  CHECK(own > 0);
  CHECK(other > 0);
}

TEST_CASE("judged_cloud__believes_no_single_station_of_points_all_over_a_building") {
  // Points spread evenly over two rooms with a wall between: from nowhere are they all seen.
  RandomStream random(6, 6);
  std::vector<double> xyz;
  for (int i = 0; i < 30000; ++i) {
    Vec3 p{8 * random.uniform(), 4 * random.uniform(), 3 * random.uniform()};
    const uint64_t face = random.below(6);
    if (face == 0) p.x = 0;
    if (face == 1) p.x = random.uniform() < 0.5 ? 4 : 4.2;
    if (face == 2) p.y = 0;
    if (face == 3) p.y = 4;
    if (face == 4) p.z = 0;
    if (face == 5) p.x = 8;
    for (int axis = 0; axis < 3; ++axis) xyz.push_back(p[axis] + 0.002 * random.normal());
  }
  Task task;
  Buffer<double> buffer(xyz.size());
  std::copy(xyz.begin(), xyz.end(), buffer.data());
  const Cloud cloud = make_cloud(std::move(buffer));
  const SurfacePlanes surface = surface_planes(cloud.octree(task), 16, task);
  CHECK(judged(cloud, surface).sights.empty());
}
