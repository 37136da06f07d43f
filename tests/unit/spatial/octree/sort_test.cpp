// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "spatial/octree/impl.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Nearly all points in a millimetre, some of them equal, and one a thousand kilometres away.
std::vector<double> skewed(size_t n) {
  RandomStream random(2, 0);
  std::vector<double> xyz;
  for (size_t i = 0; i < n; ++i)
    for (int c = 0; c < 3; ++c) xyz.push_back(i % 5 == 0 ? 0.0005 : 1e-3 * random.uniform());
  xyz[0] = 1e6;
  return xyz;
}

/// The place of a sorted position within its deepest cell, whose side is 2^10 steps.
uint64_t code_below(const Octree::Impl& tree, size_t position) {
  const auto low = [](int32_t v) { return static_cast<uint32_t>(v) & 1023; };
  return morton_code(low(tree.x[position]), low(tree.y[position]), low(tree.z[position]));
}

}  // namespace

TEST_CASE("octree_sort__puts_points_by_code_then_index_or_grid_point_each_once") {
  for (const auto& xyz : {street(9000), street(9000, 2, 0.5), skewed(9000)}) {
    Task task;
    const auto built = build(xyz);
    const Octree::Impl& tree = built->impl();
    std::vector<uint8_t> seen(tree.count, 0);
    for (size_t p = 0; p < tree.count; ++p) ++seen[tree.order[p]];
    CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<ptrdiff_t>(tree.count));
    for (size_t p = 1; p < tree.count; ++p) REQUIRE(built->code(p - 1) <= built->code(p));
    for (const Octree::Cell& cell : built->cells(kMaxLevel, task))
      for (size_t p = cell.first + 1; p < cell.first + cell.count; ++p) {
        const bool full = cell.count > kLeafPoints;
        const uint64_t before = full ? code_below(tree, p - 1) : 0,
                       here = full ? code_below(tree, p) : 0;
        // Of points on one grid point, crowds_test.cpp asks more.
        REQUIRE((before < here || (before == here && (full || tree.order[p - 1] < tree.order[p]))));
      }
  }
}

TEST_CASE("octree_sort__grid_coordinates_are_the_points_in_steps_rounded_down") {
  const auto xyz = street(2000);
  const auto built = build(xyz);
  const Octree::Impl& tree = built->impl();
  for (size_t p = 0; p < tree.count; ++p) {
    const Vec3 exact = (point(xyz, tree.order[p]) - tree.cube.origin) / tree.step;
    REQUIRE(tree.x[p] == static_cast<int32_t>(std::floor(exact.x)));
    REQUIRE(tree.y[p] == static_cast<int32_t>(std::floor(exact.y)));
    REQUIRE(tree.z[p] == static_cast<int32_t>(std::floor(exact.z)));
  }
}

TEST_CASE("octree_sort__leaves_part_the_points_and_hold_at_most_sixteen") {
  for (const auto& xyz : {street(1), street(17), street(4000), skewed(4000)}) {
    const auto built = build(xyz);
    const Octree::Impl& tree = built->impl();
    REQUIRE(tree.leaf_first.size() >= tree.leaves + 1);
    CHECK(tree.leaf_first[0] == 0);
    CHECK(tree.leaf_first[tree.leaves] == tree.count);
    for (size_t leaf = 0; leaf < tree.leaves; ++leaf) {
      REQUIRE(tree.leaf_first[leaf] < tree.leaf_first[leaf + 1]);
      REQUIRE(tree.leaf_first[leaf + 1] - tree.leaf_first[leaf] <= kLeafPoints);
    }
  }
}

TEST_CASE("octree_sort__gives_the_same_bits_for_any_threads_on_skewed_clouds") {
  const auto xyz = skewed(200000);  // more than a chunk, and a bucket that must be split
  const auto one = build(xyz, 1), four = build(xyz, 4);
  CHECK(std::equal(one->order().begin(), one->order().end(), four->order().begin()));
  CHECK(one->impl().leaves == four->impl().leaves);
}
