// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/depth_cells.h"

#include <doctest/doctest.h>

#include <map>
#include <set>

#include "base/random.h"

using namespace jalon;

TEST_CASE("depth_cells__keep_what_is_written_and_are_empty_elsewhere") {
  RandomStream random(71, 0);
  constexpr uint32_t kColumns = 3000, kRows = 517;
  DepthCells cells(kColumns, kRows);
  std::map<std::pair<uint32_t, uint32_t>, float> truth;
  for (int k = 0; k < 300; ++k) {
    const auto column = static_cast<uint32_t>(random.below(kColumns)),
               row = static_cast<uint32_t>(random.below(kRows));
    const auto place = cells.at(column, row);
    place.cell.range_m = truth[{column, row}] = static_cast<float>(k + 1);
    ++place.count;
  }
  CHECK(cells.tiles() <= 300);
  for (uint32_t row = 0; row < kRows; ++row)
    for (uint32_t column = 0; column < kColumns; ++column) {
      const auto at = truth.find({column, row});
      REQUIRE(cells.cell(column, row).range_m == (at == truth.end() ? 0 : at->second));
      REQUIRE((cells.count(column, row) > 0) == (at != truth.end()));
    }
}

TEST_CASE("depth_cells__name_the_tiles_around_those_that_exist_across_the_seam_of_a_closed_grid") {
  DepthCells cells(100, 40);  // 7 x 3 tiles
  cells.at(3, 39);
  const auto corners = [&](bool is_closed) {
    std::set<std::pair<uint32_t, uint32_t>> out;
    for (const DepthCells::Corner& c : cells.tiles_and_around(is_closed))
      out.insert({c.column, c.row});
    return out;
  };
  using Corners = std::set<std::pair<uint32_t, uint32_t>>;
  CHECK(corners(false) == Corners{{0, 16}, {16, 16}, {0, 32}, {16, 32}});
  CHECK(corners(true) == Corners{{0, 16}, {16, 16}, {96, 16}, {0, 32}, {16, 32}, {96, 32}});
  CHECK(DepthCells().tiles() == 0);
  CHECK(DepthCells().tiles_and_around(true).empty());
}
