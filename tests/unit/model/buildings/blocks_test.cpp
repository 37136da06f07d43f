// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "model/buildings/facades.h"
#include "unit/model/buildings/houses.h"

using namespace jalon;

namespace {

Blocks blocks_of_houses(const std::vector<House>& houses, double touch_m, bool corners) {
  Model model;
  for (const House& h : houses) add_house(model, h, "h");
  return blocks_of(facades_of(vertical_pieces(model, 0.05), 0.1), houses.size(), touch_m, corners);
}

}  // namespace

TEST_CASE("blocks__of_houses__touch_within_the_tolerance_and_pass_it_on") {
  const std::vector<House> row = {{{0, 0, 0}}, {{10.08, 0, 0}}, {{20.16, 0, 0}}, {{50, 0, 0}}};
  const Blocks made = blocks_of_houses(row, 0.1, true);
  CHECK(made.count == 2);
  CHECK(made.of_building == std::vector<uint32_t>{0, 0, 0, 1});
  CHECK(blocks_of_houses(row, 0.05, true).count == 4);
}

TEST_CASE("blocks__at_a_corner_alone__touch_only_if_corners_count") {
  const std::vector<House> diagonal = {{{0, 0, 0}}, {{10, 8, 0}}};
  CHECK(blocks_of_houses(diagonal, 0.1, true).count == 1);
  CHECK(blocks_of_houses(diagonal, 0.1, false).count == 2);
  CHECK(blocks_of_houses({{{0, 0, 0}}, {{10.05, 2, 0}}}, 0.1, false).count == 1);  // wall to wall
}

TEST_CASE("blocks__of_footprints_that_overlap__are_one") {
  CHECK(blocks_of_houses({{{0, 0, 0}}, {{5, 3, 0}, {1, 0, 0}, 2, 20, 5, 0}}, 0, true).count == 1);
}
