// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>

#include "spatial/octree/exact_walk.h"
#include "spatial/octree/impl.h"
#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Points that the k nearest neighbours of all points take a look at, a point.
double looked_at(const std::vector<double>& xyz, size_t k) {
  const auto built = build(xyz);
  const Octree::Impl& tree = built->impl();
  REQUIRE(tree.has_exact_boxes());
  size_t points = 0;
  for (size_t q = 0; q < tree.count; ++q) {
    std::vector<Neighbour> near(k);
    built->knn(tree.exact_point(q), static_cast<uint32_t>(k), near);
    const Neighbour last = near.back();
    exact_walk(
        tree, tree.exact_point(q),
        [&](double squared, uint32_t least) {
          return squared < last.squared_distance ||
                 (squared == last.squared_distance && least <= last.index);
        },
        [&](size_t first, size_t end) { points += end - first; });
  }
  return static_cast<double>(points) / static_cast<double>(tree.count);
}

}  // namespace

TEST_CASE(
    "exact_boxes__are_made_only_where_the_grid_does_not_tell_points_apart_or_many_are_equal") {
  CHECK_FALSE(build(street(20000))->impl().has_exact_boxes());
  CHECK_FALSE(build(street(20000, 1, 0x1p-10))->impl().has_exact_boxes());
  std::vector<double> pile = street(20000);
  for (size_t i = 0; i < 3 * 400; ++i) pile[i] = 0.3;
  CHECK_FALSE(build(pile)->impl().has_exact_boxes());
  for (size_t i = 0; i < 3 * 2000; ++i) pile[i] = 0.3;
  CHECK(build(pile)->impl().has_exact_boxes());  // of equal points the first are asked for
  for (const HostileCloud& cloud : hostile_clouds(3000)) {
    const std::string name = cloud.name;
    if (name == "halving" || name == "two clusters far apart" ||
        name == "some sixteen points a step")
      CHECK(build(cloud.xyz)->impl().has_exact_boxes());
  }
}

TEST_CASE("exact_boxes__hold_their_points_and_name_the_smallest_index") {
  for (const HostileCloud& cloud : hostile_clouds(3000)) {
    const auto built = build(cloud.xyz);
    const Octree::Impl& tree = built->impl();
    if (!tree.has_exact_boxes()) continue;
    CAPTURE(cloud.name);
    for (size_t level = 0; level < tree.exact_levels.size(); ++level)
      for (size_t i = 0; i < tree.count; ++i) {
        const size_t item = i / kExactRun >> 3 * level;
        const ExactBlock& block = tree.exact_levels[level][item / kBoxes];
        REQUIRE(squared_distance(block, item % kBoxes, tree.exact_point(i)) == 0);
        REQUIRE(block.least_index[item % kBoxes] <= tree.order[i]);
      }
    CHECK(*std::min_element(tree.exact_levels.back()[0].least_index,
                            tree.exact_levels.back()[0].least_index + kBoxes) == 0);
  }
}

TEST_CASE("exact_boxes__let_searches_look_at_few_of_equal_points_however_many") {
  for (const size_t n : {size_t{3000}, size_t{24000}}) {
    CAPTURE(n);
    std::vector<double> xyz = street(2 * n);
    for (size_t i = 0; i < 3 * n; ++i) xyz[i] = 0.3;
    CHECK(looked_at(xyz, 10) < 300);
    std::vector<Neighbour> near(10);
    REQUIRE(build(xyz)->knn({0.3, 0.3, 0.3}, 10, near) == 10);
    for (uint32_t j = 0; j < 10; ++j) CHECK(near[j].index == j);
  }
}

// What makes the time of a search: it grows with the answer, not with the crowd.
TEST_CASE("exact_boxes__let_searches_look_at_few_points_of_a_crowd_however_large") {
  for (const int n : {3000, 24000})
    for (const HostileCloud& cloud : hostile_clouds(n)) {
      const auto tree = build(cloud.xyz);
      if (!tree->impl().has_exact_boxes()) continue;
      CAPTURE(cloud.name);
      CAPTURE(n);
      CHECK(looked_at(cloud.xyz, 10) <
            300);  // 8 leaves of 16 points around that of a point, and their edges
    }
}
