// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>

#include "spatial/octree/impl.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

bool is_empty(const BoxBlock& block, size_t slot) {
  for (int axis = 0; axis < 3; ++axis)
    if (block.lo[axis][slot] <= block.hi[axis][slot]) return false;
  return true;
}

}  // namespace

TEST_CASE("boxes__of_leaves_are_the_extremes_of_their_points") {
  // One leaf, one block, one leaf more than a block, three levels.
  for (const size_t n : {1, 16, 100, 5000}) {
    const auto xyz = street(n);
    const auto built = build(xyz);
    const Octree::Impl& tree = built->impl();
    const int32_t* axes[3] = {tree.x.data(), tree.y.data(), tree.z.data()};
    for (size_t leaf = 0; leaf < tree.leaves; ++leaf) {
      const BoxBlock& block = tree.levels[0][leaf / kBoxes];
      for (int axis = 0; axis < 3; ++axis) {
        const int32_t *first = axes[axis] + tree.leaf_first[leaf],
                      *last = axes[axis] + tree.leaf_first[leaf + 1];
        REQUIRE(block.lo[axis][leaf % kBoxes] == *std::min_element(first, last));
        REQUIRE(block.hi[axis][leaf % kBoxes] == *std::max_element(first, last));
      }
    }
  }
}

TEST_CASE("boxes__of_a_level_bound_the_blocks_below_tightly_up_to_one_block") {
  const auto xyz = street(5000);
  const auto built = build(xyz);
  const Octree::Impl& tree = built->impl();
  REQUIRE(tree.levels.size() >= 3);
  CHECK(tree.levels.back().size() == 1);
  CHECK(tree.view.top == static_cast<int>(tree.levels.size()) - 1);
  for (size_t level = 1; level < tree.levels.size(); ++level) {
    const size_t below = tree.levels[level - 1].size();
    CHECK(tree.levels[level].size() == (below + kBoxes - 1) / kBoxes);
    for (size_t child = 0; child < below; ++child) {
      const BoxBlock& inner = tree.levels[level - 1][child];
      const BoxBlock& outer = tree.levels[level][child / kBoxes];
      for (int axis = 0; axis < 3; ++axis) {
        // Empty places are lo = greatest, hi = least, so they change no extreme.
        REQUIRE(outer.lo[axis][child % kBoxes] ==
                *std::min_element(inner.lo[axis], inner.lo[axis] + kBoxes));
        REQUIRE(outer.hi[axis][child % kBoxes] ==
                *std::max_element(inner.hi[axis], inner.hi[axis] + kBoxes));
      }
    }
  }
}

TEST_CASE("boxes__places_without_a_box_are_empty") {
  for (const size_t n : {1, 200, 5000}) {
    const auto xyz = street(n);
    const auto built = build(xyz);
    const Octree::Impl& tree = built->impl();
    size_t used = tree.leaves;
    for (const auto& level : tree.levels) {
      for (size_t slot = 0; slot < level.size() * kBoxes; ++slot)
        REQUIRE(is_empty(level[slot / kBoxes], slot % kBoxes) == (slot >= used));
      used = level.size();
    }
  }
}
