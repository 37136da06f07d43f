// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "spatial/octree/impl.h"
#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("crowds__hold_every_point_once_and_each_on_its_grid_point") {
  for (const HostileCloud& cloud : hostile_clouds(3000)) {
    CAPTURE(cloud.name);
    const auto built = build(cloud.xyz);
    const Octree::Impl& tree = built->impl();
    std::vector<uint8_t> seen(tree.count, 0);
    for (size_t p = 0; p < tree.count; ++p) {
      ++seen[tree.order[p]];
      const Vec3 exact = (point(cloud.xyz, tree.order[p]) - tree.cube.origin) * tree.inverse_step;
      REQUIRE(tree.x[p] == static_cast<int32_t>(exact.x));
      REQUIRE(tree.y[p] == static_cast<int32_t>(exact.y));
      REQUIRE(tree.z[p] == static_cast<int32_t>(exact.z));
    }
    CHECK(std::count(seen.begin(), seen.end(), 1) == 3000);
  }
}

// On a line, the curve goes one way; up to a leaf's points in a cell stand by index.
TEST_CASE("crowds__of_a_line_stand_in_its_order_down_to_the_smallest_number") {
  constexpr int kPoints = 4000;
  const auto rank_of = [](int i) { return i * 1237 % kPoints; };
  std::vector<double> xyz;
  for (int i = 0; i < kPoints; ++i)
    for (const double c : {std::exp(-700.0 * rank_of(i) / kPoints), 0.0, 0.0}) xyz.push_back(c);
  const auto tree = build(xyz);
  for (int p = 0; p < kPoints; ++p) {
    const int rank = kPoints - 1 - rank_of(static_cast<int>(tree->order()[static_cast<size_t>(p)]));
    REQUIRE(std::abs(rank - p) < static_cast<int>(kLeafPoints));
  }
}

// A line is some thirty crowds one in the other: of each, only what leaves it is sorted.
TEST_CASE("crowds__one_in_the_other_are_not_sorted_as_a_whole_again_and_again") {
  constexpr int kPoints = 20000;
  std::vector<double> line, halving;
  for (int i = 0; i < kPoints; ++i)
    for (const double c : {std::exp(-700.0 * i / kPoints), 0.0, 0.0}) line.push_back(c);
  CHECK(build(line)->impl().sorted_again < 2 * kPoints);
  CHECK(build(line)->impl().sorted_again > kPoints / 2);
  // Of two halves, one has the crowds.
  for (int i = 0; i < kPoints; ++i)
    for (int axis = 0; axis < 3; ++axis)
      halving.push_back(i % 2 == 0 ? std::exp(-300.0 * i / kPoints) * (1 + axis) : 1 + 1e-5 * i);
  const auto tree = build(halving);
  CHECK(tree->impl().sorted_again < 2 * kPoints);
}

TEST_CASE("crowds__of_equal_points_stay_in_the_order_of_their_indices") {
  std::vector<double> xyz;
  for (int i = 0; i < 500; ++i)
    for (int c = 0; c < 3; ++c) xyz.push_back(i % 2 == 0 ? 0.1 : i == 1 ? 1e13 : 0.1 + 1e-9 * i);
  const auto tree = build(xyz);
  uint32_t last = 0;
  size_t equal = 0;
  for (const uint32_t index : tree->order())
    if (index % 2 == 0) {
      REQUIRE((equal == 0 || index > last));
      last = index;
      ++equal;
    }
  CHECK(equal == 250);
}

TEST_CASE("crowds__give_the_same_bits_for_any_threads") {
  for (const HostileCloud& cloud : hostile_clouds(70000)) {
    CAPTURE(cloud.name);
    const auto one = build(cloud.xyz, 1), three = build(cloud.xyz, 3);
    CHECK(std::equal(one->order().begin(), one->order().end(), three->order().begin()));
  }
}
