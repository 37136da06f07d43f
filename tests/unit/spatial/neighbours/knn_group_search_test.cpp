// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Neighbours of some points, a few at a time, against single queries and brute force.
#include "spatial/neighbours/knn_group_search.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/error.h"
#include "spatial/neighbours/knn_of_some.h"
#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct OfSome {
  std::vector<uint32_t> points, neighbours;  // indices, of the neighbours k each
};

OfSome of_some(const Octree& tree, const EveryPoint& points, uint32_t k, unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  OfSome out;
  out.points.resize(points.count);
  out.neighbours.resize(points.count * k);
  const auto order = tree.order();
  for_each_nearest_of_some(tree, points, k, task, [&](const SomeNearest& of) {
    for (size_t i = 0; i < of.count; ++i) {
      out.points[of.number + i] = order[of.positions[i]];
      for (uint32_t j = 0; j < k; ++j) {
        const uint32_t found = of.neighbours[i * k + j];
        out.neighbours[(of.number + i) * k + j] = found == kNoPoint ? kNoPoint : order[found];
      }
    }
  });
  return out;
}

void check_as_brute_force(const std::vector<double>& xyz, const EveryPoint& points, uint32_t k) {
  const auto tree = build(xyz);
  const OfSome found = of_some(*tree, points, k);
  for (size_t i = 0; i < points.count; ++i) {
    const size_t position = std::min(points.first + i * points.stride, tree->size() - 1);
    REQUIRE(found.points[i] == tree->order()[position]);
    const auto truth = brute_force(xyz, point(xyz, found.points[i]), k);
    for (size_t j = 0; j < k; ++j)
      REQUIRE(found.neighbours[i * k + j] == (j < truth.size() ? truth[j].index : kNoPoint));
  }
}

}  // namespace

TEST_CASE("knn_group_search__finds_what_single_queries_find") {
  const auto xyz = street(20000);
  const auto tree = build(xyz);
  for (const size_t stride : {1u, 7u, 16u, 1000u}) {
    const EveryPoint points{stride / 2, stride, tree->size() / stride};
    const OfSome found = of_some(*tree, points, 32);
    for (size_t i = 0; i < points.count; ++i) {
      Neighbour truth[32];
      REQUIRE(tree->knn(point(xyz, found.points[i]), 32, truth) == 32);
      for (size_t j = 0; j < 32; ++j) REQUIRE(found.neighbours[32 * i + j] == truth[j].index);
    }
  }
}

TEST_CASE("knn_group_search__takes_the_last_point_for_those_behind_the_end") {
  check_as_brute_force(street(1000), {8, 16, 63}, 5);
  check_as_brute_force(street(17), {8, 16, 2}, 30);
  check_as_brute_force(street(1), {8, 16, 1}, 4);
}

TEST_CASE("knn_group_search__parts_groups_that_the_curve_leaps_within") {
  // Dense clumps far apart: the box about points of two of them holds more candidates than there is room for.
  std::vector<double> xyz;
  RandomStream random(5, 0);
  for (int clump = 0; clump < 6; ++clump)
    for (int i = 0; i < 1500; ++i)
      for (int axis = 0; axis < 3; ++axis)
        xyz.push_back((axis == 0 ? 3.0 * clump : 0) + 0.01 * random.normal());
  check_as_brute_force(xyz, {100, 700, 12}, 32);
  check_as_brute_force(xyz, {8, 16, xyz.size() / 3 / 16}, 9);
}

TEST_CASE("knn_group_search__equals_brute_force_where_the_grid_does_not_tell_points_apart") {
  for (const HostileCloud& cloud : hostile_clouds(2000)) {
    CAPTURE(cloud.name);
    check_as_brute_force(cloud.xyz, {3, 11, 150}, 12);
  }
}

TEST_CASE("knn_group_search__gives_the_same_whatever_the_threads") {
  const auto tree = build(street(30000));
  const EveryPoint points{8, 16, 1875};
  const OfSome one = of_some(*tree, points, 20, 1), four = of_some(*tree, points, 20, 4);
  CHECK(one.points == four.points);
  CHECK(one.neighbours == four.neighbours);
}

TEST_CASE("knn_group_search__refuses_a_number_of_neighbours_beyond_its_range") {
  const auto tree = build(street(10));
  Task task;
  for (const uint32_t k : {0u, 257u})
    CHECK_THROWS_AS(for_each_nearest_of_some(*tree, {0, 1, 10}, k, task, [](const SomeNearest&) {}),
                    Error);
}
