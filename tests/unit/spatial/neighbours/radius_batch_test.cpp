// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "spatial/neighbours/radius_batch.h"
#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("radius_batch__equals_brute_force_in_order_for_any_threads") {
  const auto xyz = street(3000);
  const size_t n = xyz.size() / 3;
  std::vector<Vec3> queries;  // more than one chunk; the last are far away from everything
  for (size_t i = 0; i < 600; ++i) queries.push_back(point(xyz, 5 * i) + Vec3{0.05, 0, -0.02});
  for (size_t i = 0; i < 3; ++i) queries.push_back({1000, 0, 0});
  const double radius_m = 0.9;
  for (const unsigned count : {1u, 3u}) {
    Task task(threads(count));
    const RadiusNeighbours found = radius_neighbours(*build(xyz), queries, radius_m, task);
    const auto first = found.ranges.require("first").values<uint64_t>();
    const auto index = found.neighbours.require("index").values<uint64_t>();
    const auto distance = found.neighbours.require("distance").values<double>();
    REQUIRE(first.size() == queries.size() + 1);
    REQUIRE(first.back() == index.size());
    size_t at = 0;
    for (size_t q = 0; q < queries.size(); ++q) {
      REQUIRE(first[q] == at);
      for (size_t i = 0; i < n; ++i) {
        const double squared = squared_norm(point(xyz, i) - queries[q]);
        if (squared > radius_m * radius_m) continue;
        REQUIRE(index[at] == i);
        REQUIRE(distance[at++] == std::sqrt(squared));
      }
    }
    CHECK(at == index.size());
    CHECK(at > 1000);
  }
}

TEST_CASE("radius_batch__gives_the_same_whether_neighbours_are_kept_or_searched_again") {
  const auto xyz = street(4000);
  const auto tree = build(xyz);
  std::vector<Vec3> queries;
  for (size_t i = 0; i < 1000; ++i) queries.push_back(point(xyz, 4 * i));
  Task task(threads(3));
  const RadiusNeighbours all = radius_neighbours(*tree, queries, 1.2, task);
  const auto values = [](const RadiusNeighbours& found) {
    const auto index = found.neighbours.require("index").values<uint64_t>();
    const auto distance = found.neighbours.require("distance").values<double>();
    std::vector<std::pair<uint64_t, double>> out;
    for (size_t i = 0; i < index.size(); ++i) out.emplace_back(index[i], distance[i]);
    return out;
  };
  REQUIRE(values(all).size() > 3000);
  for (const size_t most_kept : {size_t{0}, size_t{1500}}) {
    const RadiusNeighbours few = radius_neighbours(*tree, queries, 1.2, task, most_kept);
    CHECK(values(few) == values(all));
  }
}

TEST_CASE("radius_batch__equals_brute_force_where_the_grid_does_not_tell_points_apart") {
  for (const HostileCloud& cloud : hostile_clouds(900)) {
    CAPTURE(cloud.name);
    const auto tree = build(cloud.xyz);
    std::vector<Vec3> queries;
    for (size_t i = 0; i < 900; i += 13) queries.push_back(point(cloud.xyz, i));
    for (const double radius_m : {0.0, 1e-30, 0.3}) {
      Task task;
      const RadiusNeighbours found = radius_neighbours(*tree, queries, radius_m, task);
      const auto first = found.ranges.require("first").values<uint64_t>();
      const auto index = found.neighbours.require("index").values<uint64_t>();
      size_t at = 0;
      for (size_t q = 0; q < queries.size(); ++q) {
        REQUIRE(first[q] == at);
        for (size_t i = 0; i < 900; ++i)
          if (squared_norm(point(cloud.xyz, i) - queries[q]) <= radius_m * radius_m)
            REQUIRE(index[at++] == i);
      }
      CHECK(at == index.size());
    }
  }
}

TEST_CASE("radius_batch__without_queries_has_one_row_of_ranges_and_no_neighbours") {
  Task task;
  const RadiusNeighbours found = radius_neighbours(*build(street(100)), {}, 1, task);
  REQUIRE(found.ranges.require("first").count() == 1);
  CHECK(found.ranges.require("first").number(0) == 0);
  CHECK(found.neighbours.require("index").count() == 0);
  CHECK(found.neighbours.require("distance").info().unit == "m");
}
