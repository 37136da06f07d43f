// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What closes an opening.
#include <doctest/doctest.h>

#include <numeric>

#include "modelling/walls/joinery.h"

using namespace jalon;

namespace {

/// Blocks first ... first + count - 1; cells as told.
HoleFiller filler(uint32_t label, double depth_m, uint32_t cells, uint32_t first, uint32_t count) {
  HoleFiller out;
  out.label = label;
  out.depth_m = depth_m;
  out.cells = cells;
  out.blocks.resize(count);
  std::iota(out.blocks.begin(), out.blocks.end(), first);
  return out;
}

uint32_t closing(const std::vector<HoleFiller>& fillers,
                 std::vector<uint32_t>* standing = nullptr) {
  HoleContent content;
  content.parallel = fillers;
  const Joinery found = joinery_of(content, 0.03);
  if (standing != nullptr) *standing = found.standing;
  return found.filler != nullptr ? found.filler->label : 0;
}

}  // namespace

TEST_CASE("joinery__is_the_frame_before_its_glass_but_no_handle") {
  CHECK(closing({filler(1, 0.24, 300, 0, 20), filler(2, 0.20, 100, 0, 20)}) == 2);
  CHECK(closing({filler(1, 0.24, 300, 0, 20), filler(2, 0.20, 20, 0, 2)}) == 1);
}

TEST_CASE("joinery__of_two_levels_is_the_larger_one_or_the_deeper_one_beside_it") {
  const HoleFiller pane = filler(1, 0.2, 300, 0, 20), parapet = filler(2, 0.08, 400, 20, 20);
  std::vector<uint32_t> standing;
  CHECK(closing({parapet, pane}, &standing) == 1);  // panes above a parapet
  CHECK(standing == std::vector<uint32_t>{2});
  CHECK(closing({filler(2, 0.08, 100, 0, 20), pane}) == 1);
  CHECK(closing({parapet, filler(1, 0.2, 50, 0, 5)}) == 2);  // too small to close it
}

TEST_CASE("joinery__a_pane_before_a_curtain_closes_the_opening") {
  const HoleFiller curtain = filler(1, 0.4, 400, 0, 20);
  CHECK(closing({curtain, filler(2, 0.2, 250, 0, 15)}) == 2);
  CHECK(closing({curtain, filler(2, 0.2, 150, 0, 15)}) == 1);   // a few mullions
  CHECK(closing({curtain, filler(2, 0.2, 250, 20, 15)}) == 1);  // elsewhere
}

TEST_CASE("joinery__lies_behind_the_wall_and_what_is_flush_or_before_it_stands_in_the_opening") {
  std::vector<uint32_t> standing;
  CHECK(closing({filler(1, 0.02, 300, 0, 20), filler(2, -0.1, 50, 0, 5), filler(0, -0.2, 9, 0, 2)},
                &standing) == 0);
  CHECK(standing == std::vector<uint32_t>{1, 2});  // 0 is no segment
  CHECK(closing({}, &standing) == 0);
  CHECK(standing.empty());
}

TEST_CASE("joinery__of_many_small_fillers_is_the_largest") {
  // Twelve at one depth, none a tenth of them all: panes, bars and furniture in a large hole.
  std::vector<HoleFiller> many;
  for (uint32_t k = 0; k < 12; ++k) many.push_back(filler(k + 1, 0.4, k == 7 ? 36 : 33, k, 1));
  CHECK(closing(many) == 8);
}
