// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// From what points mark in a cell to its state.
#include <doctest/doctest.h>

#include <algorithm>

#include "base/random.h"
#include "modelling/evidence/cell_classes.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;

namespace {

// Marks of a wall of so many cells, and their states.
struct MarkedWall {
  uint32_t columns, rows;
  double cell_m;
  std::vector<uint8_t> marks;

  MarkedWall(uint32_t columns_, uint32_t rows_, double cell_m_, uint8_t mark = kMarkOn)
      : columns(columns_), rows(rows_), cell_m(cell_m_), marks(size_t{columns_} * rows_, mark) {}
  MarkedWall& with(const CellBox& box, uint8_t mark) {
    painted::paint(marks, columns, box, mark);
    return *this;
  }
  WallCells cells() const {
    WallCells out = painted::cells_of(columns, rows, WallState::kDeep, cell_m);
    Task task;
    classify_cells(marks, out, task);
    return out;
  }
};

size_t count_in(const WallCells& cells, const CellBox& box, WallState state) {
  size_t n = 0;
  for (uint32_t r = box.r0; r < box.r1; ++r)
    for (uint32_t c = box.c0; c < box.c1; ++c) n += cells.at(c, r) == state;
  return n;
}

bool is_all(const WallCells& cells, const CellBox& box, WallState state) {
  return count_in(cells, box, state) == size_t{box.width()} * box.height();
}

}  // namespace

TEST_CASE("classify_cells__takes_the_strongest_mark_of_a_cell_for_all_sets_of_marks") {
  MarkedWall wall(60, 60, 0.05);
  constexpr uint8_t kAll = 127;
  wall.with({0, 50, 60, 60}, kAll);
  // Each by itself in the wall; even: not on the plane.
  const auto column = [](uint32_t set) { return 10 + set / 2 % 20 * 2; };
  const auto row = [](uint32_t set) { return 10 + set / 2 / 20 * 2; };
  for (uint32_t set = 0; set <= kAll; set += 2)
    wall.marks[row(set) * size_t{60} + column(set)] = static_cast<uint8_t>(set);
  const WallCells cells = wall.cells();
  CHECK(is_all(cells, {0, 50, 60, 60}, WallState::kOn));
  constexpr std::pair<uint8_t, WallState> kOrder[] = {
      {kMarkBehind, WallState::kThrough}, {kMarkFlush, WallState::kStrip},
      {kMarkRelief, WallState::kRelief},  {kMarkProud, WallState::kProud},
      {kMarkBefore, WallState::kHidden},  {kMarkDeep, WallState::kDeep},
      {0xff, WallState::kEmpty}};
  for (uint32_t set = 0; set <= kAll; set += 2) {
    const auto first = std::find_if(std::begin(kOrder), std::end(kOrder) - 1,
                                    [&](const auto& mark) { return (set & mark.first) != 0; });
    CAPTURE(set);
    CHECK(cells.at(column(set), row(set)) == first->second);
  }
}

TEST_CASE("classify_cells__points_in_strips_narrower_than_a_pier_are_strips_and_piers_are_wall") {
  const CellBox hole{20, 20, 60, 60}, middle{20, 34, 60, 46};  // 2 x 2 m at 5 cm
  const auto bar = [&](uint32_t width) {
    return MarkedWall(80, 80, 0.05).with(hole, 0).with({39, 20, 39 + width, 60}, kMarkOn).cells();
  };
  const WallCells mullion = bar(2), pier = bar(3);  // 10 cm, 15 cm
  CHECK(count_in(mullion, middle, WallState::kStrip) == 2 * 12);
  CHECK(count_in(mullion, middle, WallState::kOn) == 0);
  CHECK(count_in(pier, middle, WallState::kOn) == 3 * 12);
  CHECK(count_in(pier, middle, WallState::kStrip) == 0);
  CHECK(is_all(mullion, {0, 0, 80, 20}, WallState::kOn));
}

TEST_CASE("classify_cells__pilasters_are_relief_and_parapets_and_pipes_stand_proud") {
  const auto proud = [](uint32_t rows, uint8_t mark) {  // 35 cm wide
    return MarkedWall(80, 80, 0.05).with({39, 10, 46, 10 + rows}, mark).cells();
  };
  constexpr uint8_t kParallel = kMarkProud | kMarkParallel;
  CHECK(is_all(proud(60, kParallel), {39, 10, 46, 70}, WallState::kRelief));  // 3 m
  CHECK(is_all(proud(26, kParallel), {39, 10, 46, 36}, WallState::kProud));   // 1.3 m
  CHECK(is_all(proud(60, kMarkProud), {39, 10, 46, 70}, WallState::kProud));
  CHECK(is_all(proud(60, kParallel | kMarkBehind), {39, 10, 46, 70}, WallState::kThrough));
}

TEST_CASE("classify_cells__bars_of_a_railing_hide_a_window_and_signs_and_sills_stand_proud") {
  const CellBox window{20, 20, 44, 60}, sill{18, 18, 46, 20}, sign{50, 30, 70, 50};
  MarkedWall wall(80, 80, 0.05);
  wall.with(window, kMarkBehind).with(sill, kMarkProud).with(sign, kMarkProud);
  for (uint32_t c = window.c0; c < window.c1; c += 4) {
    wall.with({c, 20, c + 2, 40}, kMarkProud);
    wall.with({c + 2, 20, c + 4, 40}, 0);
  }
  const WallCells cells = wall.cells();
  const CellBox bars{20, 20, 44, 40};
  CHECK(count_in(cells, bars, WallState::kHidden) == 24 * 20 / 2);
  CHECK(count_in(cells, bars, WallState::kEmpty) == 24 * 20 / 2);
  CHECK(is_all(cells, sill, WallState::kProud));
  CHECK(is_all(cells, sign, WallState::kProud));
}

TEST_CASE("classify_cells__at_coarse_spacing_two_cells_are_a_pier_and_one_is_none") {
  const auto bar = [&](uint32_t width) {
    return MarkedWall(80, 80, 0.2)
        .with({20, 20, 60, 60}, 0)
        .with({39, 20, 39 + width, 60}, kMarkOn)
        .cells();
  };
  CHECK(is_all(bar(2), {39, 34, 41, 46}, WallState::kOn));
  CHECK(is_all(bar(1), {39, 34, 40, 46}, WallState::kStrip));
}

TEST_CASE("classify_cells__a_wall_whose_points_lie_thinly_is_no_strip") {
  RandomStream random(5, 3);
  MarkedWall wall(100, 80, 0.05);
  for (uint8_t& mark : wall.marks) mark = random.uniform() < 0.7 ? kMarkOn : 0;
  CHECK(count_in(wall.cells(), {0, 0, 100, 80}, WallState::kStrip) == 0);
}

TEST_CASE("classify_cells__a_leaf_flush_with_the_wall_and_apart_from_it_is_a_strip") {
  // A shop front of 2 x 2.5 m with a leaf of 0.3 x 1 m in the wall's plane; the same joined to the wall is wall, as is
  // what stands among things that nobody saw through.
  const CellBox leaf{38, 10, 44, 30}, front{30, 0, 70, 50};
  const auto with = [&](uint8_t about, const CellBox& part) {
    return MarkedWall(100, 80, 0.05).with(front, about).with(part, kMarkOn).cells();
  };
  CHECK(is_all(with(kMarkBehind, leaf), leaf, WallState::kStrip));
  const CellBox pier{38, 10, 44, 50};
  CHECK(is_all(with(kMarkBehind, pier), pier, WallState::kOn));
  CHECK(is_all(with(kMarkBefore, leaf), leaf, WallState::kOn));
}

TEST_CASE("classify_cells__patches_of_a_rooms_wall_are_no_leaves") {
  MarkedWall room(120, 60, 0.05, kMarkBehind);
  const CellBox patches[] = {{10, 20, 30, 40}, {50, 20, 70, 40}, {90, 20, 110, 40}};
  for (const CellBox& patch : patches) room.with(patch, kMarkOn);
  const WallCells cells = room.cells();
  for (const CellBox& patch : patches) CHECK(is_all(cells, patch, WallState::kOn));
}

TEST_CASE("classify_cells__the_sky_between_gables_is_outside_and_a_window_in_one_is_not") {
  // Two gables of 20 cells' width on a wall of 10 rows.
  MarkedWall wall(40, 24, 0.2, 0);
  wall.with({0, 0, 40, 10}, kMarkOn);
  for (uint32_t c = 0; c < 40; ++c) {
    const uint32_t half = c % 20 < 10 ? c % 20 : 19 - c % 20;
    wall.with({c, 10, c + 1, 11 + half}, kMarkOn);
  }
  wall.with({8, 11, 12, 14}, 0);
  const WallCells cells = wall.cells();
  CHECK(cells.at(20, 18) == WallState::kOutside);  // wall to the left and right, none above
  CHECK(cells.at(0, 20) == WallState::kOutside);
  CHECK(is_all(cells, {9, 12, 11, 13}, WallState::kEmpty));
}

TEST_CASE("classify_cells__what_was_seen_through_between_walls_is_inside_and_what_is_hidden_not") {
  for (const auto& [mark, state] : {std::pair{kMarkBehind, WallState::kThrough},
                                    {kMarkBefore, WallState::kOutside},
                                    {kMarkDeep, WallState::kOutside}}) {
    // Open upwards: a gap between two walls.
    const WallCells cells = MarkedWall(40, 24, 0.2).with({15, 0, 25, 24}, mark).cells();
    CHECK(is_all(cells, {15, 0, 25, 24}, state));
  }
  // At the end of the wall nothing is beside it.
  const WallCells end = MarkedWall(40, 24, 0.2).with({30, 0, 40, 24}, kMarkBehind).cells();
  CHECK(is_all(end, {30, 0, 40, 24}, WallState::kOutside));
}

TEST_CASE("classify_cells__a_gateway_reaches_the_foot_of_the_wall_beside_it_and_no_lower") {
  // Foot of the wall at row 2; cells of half a metre, so that 4 m are 8 of them.
  const WallCells gateway =
      MarkedWall(60, 20, 0.5).with({0, 0, 60, 2}, 0).with({20, 2, 28, 10}, 0).cells();
  CHECK(is_all(gateway, {20, 2, 28, 10}, WallState::kEmpty));
  CHECK(is_all(gateway, {0, 0, 60, 2}, WallState::kOutside));
  // Ground that rises by a step: under the higher part is outside but next to the step.
  const WallCells step = MarkedWall(60, 20, 0.5).with({30, 0, 60, 6}, 0).cells();
  CHECK(is_all(step, {30, 0, 38, 6}, WallState::kEmpty));
  CHECK(is_all(step, {38, 0, 60, 6}, WallState::kOutside));
}

TEST_CASE("classify_cells__nothing_is_a_wall_without_a_cell_on_the_plane") {
  const WallCells cells = MarkedWall(10, 8, 0.1, kMarkBehind).cells();
  CHECK(is_all(cells, {0, 0, 10, 8}, WallState::kOutside));
  CHECK(MarkedWall(0, 0, 0.1).cells().empty());
}
