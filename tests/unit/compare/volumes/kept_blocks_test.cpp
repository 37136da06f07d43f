// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/volumes/kept_blocks.h"

#include <doctest/doctest.h>

using namespace jalon;

TEST_CASE("kept_blocks__keep_what_has_points_with_a_block_on_either_side") {
  constexpr uint32_t kSide = KeptBlocks::kBlock, kCells = 20 * kSide - 3;
  std::vector<uint8_t> has_points(KeptBlocks::blocks_of(kCells), 0);
  REQUIRE(has_points.size() == 20);
  has_points[7] = has_points[19] = 1;
  const KeptBlocks kept(has_points);
  // 0 for it is the first; 6, 7, 8; 18, 19.
  CHECK(kept.left_out() == 14 * kSide);
  CHECK(kCells - kept.left_out() == 6 * kSide - 3);
  const uint32_t numbers[] = {0, 6, 7, 8, 18, 19};
  for (uint32_t place = 0; place < 6; ++place)
    for (const uint32_t within : {0u, 1u, kSide - 4}) {
      const uint32_t cell = numbers[place] * kSide + within;
      CHECK(kept.kept_of(cell) == place * kSide + within);
      CHECK(kept.cell_of(kept.kept_of(cell)) == cell);
    }
}

TEST_CASE("kept_blocks__without_any_far_from_points_number_as_before") {
  const std::vector<uint8_t> has_points = {0, 1, 0, 0, 1, 1, 0};
  for (const KeptBlocks& kept : {KeptBlocks(), KeptBlocks(has_points)}) {
    CHECK(kept.left_out() == 0);
    for (const uint32_t cell : {0u, 200u, 447u}) {
      CHECK(kept.kept_of(cell) == cell);
      CHECK(kept.cell_of(cell) == cell);
    }
  }
}
