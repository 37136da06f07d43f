// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/octree/distinct_points.h"

#include <doctest/doctest.h>

#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// A street in which every second point is the same one.
std::vector<double> street_with_a_pile(size_t n) {
  std::vector<double> xyz = street(n);
  for (size_t i = 1; i < n; i += 2) {
    xyz[3 * i] = 7.25;
    xyz[3 * i + 1] = 3.5;
    xyz[3 * i + 2] = 1.125;
  }
  return xyz;
}

}  // namespace

TEST_CASE("distinct_points__of_a_cloud_without_piles_are_the_tree_itself") {
  const auto xyz = street(3000);
  const auto tree = build(xyz);
  Task task;
  const DistinctPoints distinct(*tree, task);
  CHECK(&distinct.tree() == tree.get());
  for (uint32_t p = 0; p < 3000; p += 97) CHECK(distinct.position(p) == p);
}

TEST_CASE("distinct_points__leave_a_few_leaves_of_a_pile_and_every_other_point") {
  const auto xyz = street_with_a_pile(4000);
  const auto tree = build(xyz);
  Task task;
  const DistinctPoints distinct(*tree, task);
  CHECK(distinct.tree().size() >= 2001);
  CHECK(distinct.tree().size() <= 2000 + 2 * 16);
  std::vector<uint8_t> kept(4000, 0);
  for (uint32_t p = 0; p < distinct.tree().size(); ++p) {
    const uint32_t position = distinct.position(p);
    REQUIRE(position < 4000);
    ++kept[tree->order()[position]];
  }
  for (size_t i = 0; i < kept.size(); i += 2) REQUIRE(kept[i] == 1);
  CHECK(kept[1] == 1);  // the first of the pile
}

TEST_CASE("distinct_points__answer_nearest_questions_like_brute_force_over_all") {
  const auto xyz = street_with_a_pile(4000);
  const auto tree = build(xyz);
  Task task;
  const DistinctPoints distinct(*tree, task);
  RandomStream random(9, 0);
  for (int i = 0; i < 200; ++i) {
    Vec3 q{20 * random.uniform(), 20 * random.uniform(), 20 * random.uniform()};
    if (i % 4 == 0) q = {7.25, 3.5, 1.125 + 0.001 * i};
    Neighbour found{};
    REQUIRE(distinct.tree().knn_positions(q, 1, {&found, 1}) == 1);
    const Neighbour truth = brute_force(xyz, q, 1)[0];
    CHECK(tree->order()[distinct.position(found.index)] == truth.index);
    CHECK(found.squared_distance == truth.squared_distance);
  }
}
