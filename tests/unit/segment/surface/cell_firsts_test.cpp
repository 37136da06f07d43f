// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/cell_firsts.h"

#include <doctest/doctest.h>

#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("cell_firsts__are_where_the_cells_of_each_level_begin_for_any_number_of_threads") {
  std::vector<double> xyz = street(150'000);
  for (int i = 0; i < 100; ++i) xyz.insert(xyz.end(), {1, 2, 3});  // equal codes begin one cell
  const auto tree = build(xyz);
  Buffer<uint8_t> scratch(tree->size());
  Task one(threads(1)), seven(threads(7));
  const auto firsts = cell_firsts(*tree, 3, kMaxLevel, scratch, one);
  REQUIRE(firsts.size() == size_t{kMaxLevel} - 2);
  CHECK(firsts == cell_firsts(*tree, 3, kMaxLevel, scratch, seven));
  for (int level = 3; level <= kMaxLevel; ++level) {
    const auto& own = firsts[static_cast<size_t>(level) - 3];
    std::vector<uint32_t> expected;
    for (const Octree::Cell& cell : tree->cells(level, one))
      expected.push_back(static_cast<uint32_t>(cell.first));
    expected.push_back(static_cast<uint32_t>(tree->size()));
    CHECK(own == expected);
  }
}

TEST_CASE("cell_firsts__of_one_level_and_a_single_point") {
  const auto tree = build({1, 2, 3});
  Buffer<uint8_t> scratch(1);
  Task task;
  CHECK(cell_firsts(*tree, 0, 0, scratch, task) == std::vector<std::vector<uint32_t>>{{0, 1}});
}
