// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Narrow piers between broad windows, in cells painted by hand.
#include <doctest/doctest.h>

#include "modelling/evidence/piers.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;

namespace {

constexpr CellBox kRibbon{10, 10, 110, 40};  // 5 x 1.5 m in cells of 5 cm

WallCells ribbon_with(const CellBox& bar, WallState state) {
  WallCells out = painted::cells_of(120, 60);
  painted::paint(out, kRibbon, WallState::kThrough);
  painted::paint(out, bar, state);
  return out;
}

}  // namespace

TEST_CASE("pier_columns__are_those_where_the_wall_goes_from_foot_to_head") {
  CHECK(pier_columns(ribbon_with({50, 10, 51, 40}, WallState::kOn), kRibbon) ==
        std::vector<uint32_t>{49, 50});
  CHECK(pier_columns(ribbon_with({50, 10, 51, 40}, WallState::kStrip), kRibbon).size() == 2);
  CHECK(pier_columns(ribbon_with({50, 10, 51, 30}, WallState::kOn), kRibbon).empty());
  CHECK(pier_columns(ribbon_with({50, 10, 51, 40}, WallState::kHidden), kRibbon).empty());
}

TEST_CASE("pier_columns__beside_a_light_there_are_mullions_alone") {
  CHECK(pier_columns(ribbon_with({30, 10, 32, 40}, WallState::kOn), kRibbon).empty());
  CHECK(pier_columns(ribbon_with({30, 10, 32, 40}, WallState::kOn), {0, 0, 0, 0}).empty());
}

TEST_CASE("beside_pier__takes_the_larger_part_and_a_box_without_pier_as_it_is") {
  const CellBox right = beside_pier(ribbon_with({50, 10, 52, 40}, WallState::kOn), kRibbon);
  CHECK(right.c0 >= 51);
  CHECK(right.c0 <= 52);
  CHECK(right.c1 == 110);
  const CellBox whole = beside_pier(ribbon_with({50, 10, 52, 20}, WallState::kOn), kRibbon);
  CHECK(whole.width() == kRibbon.width());
}
