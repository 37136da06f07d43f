// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Rectangles that canopies and signs made of two openings.
#include <doctest/doctest.h>

#include "modelling/evidence/shape_trim.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;
using painted::cells_of;
using painted::paint;
using painted::rectangle;

namespace {

// Something was seen through columns 20 to 40 and rows 10 to 70, but in a band of rows 35 to 45.
WallCells wall_with_band(WallState band, uint32_t from_column, uint32_t to_column) {
  WallCells cells = cells_of(60, 80);
  paint(cells, {20, 10, 40, 70}, WallState::kThrough);
  paint(cells, {from_column, 35, to_column, 45}, band);
  return cells;
}
const OpeningShape kTall = rectangle(20.3, 39.8, 10.2, 70);

}  // namespace

TEST_CASE("parts_of__a_blank_band_that_goes_on_beside_is_cut_out") {
  for (const auto& [from, to] : {std::pair{10u, 50u}, {10u, 40u}, {20u, 50u}}) {
    const auto parts = parts_of(wall_with_band(WallState::kEmpty, from, to), kTall);
    REQUIRE(parts.size() == 2);
    // Sides that stay keep their fractions of a cell.
    CHECK(parts[0].sizes == rectangle(20.3, 39.8, 10.2, 35).sizes);
    CHECK(parts[1].sizes == rectangle(20.3, 39.8, 45, 70).sizes);
  }
}

TEST_CASE("parts_of__a_blank_band_that_ends_at_the_jambs_is_a_transom_of_one_opening") {
  const auto parts = parts_of(wall_with_band(WallState::kEmpty, 20, 40), kTall);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].sizes == kTall.sizes);
}

TEST_CASE("parts_of__a_band_that_something_hides_or_that_was_seen_through_is_not_cut") {
  CHECK(parts_of(wall_with_band(WallState::kHidden, 10, 50), kTall).size() == 1);
  CHECK(parts_of(wall_with_band(WallState::kDeep, 10, 50), kTall).size() == 1);
}

TEST_CASE("parts_of__a_neighbours_opening_behind_a_pier_is_no_band_that_goes_on") {
  for (const bool is_right : {true, false}) {
    WallCells cells = wall_with_band(WallState::kEmpty, 20, 40);
    if (is_right) paint(cells, {43, 10, 55, 70}, WallState::kThrough);
    else paint(cells, {5, 10, 17, 70}, WallState::kThrough);
    CHECK(parts_of(cells, kTall).size() == 1);
  }
}

TEST_CASE("parts_of__stray_points_behind_a_band_leave_it_blank") {
  WallCells cells = wall_with_band(WallState::kEmpty, 10, 50);
  for (const auto& [column, row] : {std::pair{22u, 35u},
                                    {37u, 37u},
                                    {26u, 39u},
                                    {33u, 39u},
                                    {29u, 41u},
                                    {24u, 43u},
                                    {38u, 44u}})
    paint(cells, {column, row, column + 1, row + 1}, WallState::kThrough);
  const auto parts = parts_of(cells, kTall);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].sizes == rectangle(20.3, 39.8, 10.2, 35).sizes);
  CHECK(parts[1].sizes == rectangle(20.3, 39.8, 45, 70).sizes);
  // Three times as many are none.
  for (uint32_t row = 35; row < 45; ++row)
    paint(cells, {25, row, 27, row + 1}, WallState::kThrough);
  CHECK(parts_of(cells, kTall).size() == 1);
}

TEST_CASE("parts_of__bands_across_both_ways_leave_four_parts") {
  WallCells cells = cells_of(80, 80);
  paint(cells, {20, 20, 60, 60}, WallState::kThrough);
  paint(cells, {0, 37, 80, 43}, WallState::kEmpty);
  paint(cells, {37, 0, 43, 80}, WallState::kEmpty);
  CHECK(parts_of(cells, rectangle(20, 60, 20, 60)).size() == 4);
}

TEST_CASE("parts_of__an_opening_that_nothing_was_seen_through_stays_whole") {
  WallCells cells = wall_with_band(WallState::kEmpty, 10, 50);
  paint(cells, {20, 10, 40, 35}, WallState::kEmpty);  // its lower part
  CHECK(parts_of(cells, kTall).size() == 1);
  paint(cells, {20, 10, 40, 70}, WallState::kEmpty);
  CHECK(parts_of(cells, kTall).size() == 1);
}

TEST_CASE("parts_of__other_forms_stay_as_they_are") {
  const OpeningShape arch{ShapeKind::kArch, {20, 40, 10, 70, 8, 0}};
  const auto parts = parts_of(wall_with_band(WallState::kEmpty, 10, 50), arch);
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].sizes == arch.sizes);
}
