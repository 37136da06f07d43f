// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Cells in a shape, and what lies beside its border.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/evidence/shape_cells.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;
using painted::cells_of;
using painted::paint;
using painted::rectangle;

namespace {

size_t cell_count(const WallCells& cells, const OpeningShape& shape) {
  size_t n = 0;
  for_cells(cells, shape, [&](uint32_t c, uint32_t r) {
    REQUIRE(c < cells.columns);
    REQUIRE(r < cells.rows);
    ++n;
  });
  return n;
}

// A wall of 60 x 60 cells with an opening of 20 x 20 in its middle.
WallCells wall_with_square() {
  WallCells cells = cells_of(60, 60);
  paint(cells, {20, 20, 40, 40}, WallState::kThrough);
  return cells;
}
const OpeningShape kSquare = rectangle(20, 40, 20, 40);

}  // namespace

TEST_CASE("for_cells__are_those_whose_centres_lie_in_the_shape") {
  const WallCells cells = cells_of(60, 50);
  CHECK(cell_count(cells, rectangle(10, 20, 5, 8)) == 30);
  CHECK(cell_count(cells, rectangle(10.4, 20.4, 5.4, 8.4)) == 30);
  CHECK(cell_count(cells, rectangle(10.6, 20.4, 5, 8)) == 27);
  CHECK(cell_count(cells, rectangle(-10, 100, -10, 100)) == 60 * 50);  // what is there of it
  CHECK(cell_count(cells, rectangle(70, 80, 5, 8)) == 0);
  const OpeningShape circle{ShapeKind::kCircle, {30, 25, 20, 0, 0, 0}};
  CHECK(std::fabs(static_cast<double>(cell_count(cells, circle)) - M_PI * 400) < 20);
}

TEST_CASE("bordered_share__counts_the_sides_with_wall_just_outside_them") {
  WallCells cells = wall_with_square();
  CHECK(bordered_share(cells, kSquare, Sides::kAll) == 1);
  CHECK(bordered_share(cells, rectangle(21, 39, 21, 39), Sides::kAll) == 1);  // near enough
  CHECK(bordered_share(cells, rectangle(25, 35, 25, 35), Sides::kAll) == 0);
  paint(cells, {10, 20, 20, 40}, WallState::kHidden);  // the whole left side
  CHECK(bordered_share(cells, kSquare, Sides::kAll) ==
        doctest::Approx(0.75).epsilon(0.02).scale(0));
  paint(cells, {10, 20, 20, 40}, WallState::kOutside);  // it does not count
  CHECK(bordered_share(cells, kSquare, Sides::kAll) == 1);
}

TEST_CASE("bordered_share__of_sloping_sides_leaves_upright_and_level_ones_out") {
  WallCells cells = wall_with_square();
  paint(cells, {10, 20, 20, 40}, WallState::kHidden);
  CHECK(bordered_share(cells, kSquare, Sides::kSloping) == 1);  // none
  // Both slopes of a gable whose right half nobody saw.
  const OpeningShape gable{ShapeKind::kGable, {20, 40, 20, 40, 10, 0}};
  for (uint32_t r = 30; r < 40; ++r) {
    paint(cells, {20, r, r - 10, r + 1}, WallState::kOn);
    paint(cells, {70 - r, r, 40, r + 1}, WallState::kHidden);
  }
  // Of 14 places a slope the last three of the right one have the wall above the top just outside them.
  CHECK(bordered_share(cells, gable, Sides::kSloping) ==
        doctest::Approx(17.0 / 28).epsilon(0.01).scale(0));
}

TEST_CASE("relief_share__is_that_of_the_border_where_relief_comes_first") {
  WallCells cells = wall_with_square();
  CHECK(relief_share(cells, kSquare) == 0);
  paint(cells, {16, 20, 20, 40}, WallState::kRelief);
  CHECK(relief_share(cells, kSquare) == doctest::Approx(0.25).epsilon(0.05).scale(0));
  CHECK(bordered_share(cells, kSquare, Sides::kAll) == 1);  // relief lies on wall
  paint(cells, {16, 16, 44, 44}, WallState::kRelief);
  paint(cells, {20, 20, 40, 40}, WallState::kThrough);
  CHECK(relief_share(cells, kSquare) == 1);
  // Wall between the opening and the relief.
  paint(cells, {19, 19, 41, 41}, WallState::kOn);
  paint(cells, {20, 20, 40, 40}, WallState::kThrough);
  CHECK(relief_share(cells, kSquare) == 0);
}

TEST_CASE("framed_share__is_that_of_the_border_beyond_which_the_wall_is_broad") {
  WallCells cells = wall_with_square();
  CHECK(framed_share(cells, kSquare) == 1);
  // A surround or a strip of leaves lies between.
  paint(cells, {18, 20, 20, 40}, WallState::kRelief);
  CHECK(framed_share(cells, kSquare) == 1);
  // The wall ends: beyond it there is nothing, or a strip of two cells alone.
  paint(cells, {0, 20, 20, 40}, WallState::kOutside);
  CHECK(framed_share(cells, kSquare) == doctest::Approx(0.75).epsilon(0.02).scale(0));
  paint(cells, {18, 20, 20, 40}, WallState::kOn);
  CHECK(framed_share(cells, kSquare) == doctest::Approx(0.75).epsilon(0.02).scale(0));
}

TEST_CASE("open_ends__tell_gaps_between_dormers_from_windows_and_doors") {
  // Two dormers of 20 x 20 cells, the sky over them and between; a window in one.
  WallCells cells = cells_of(60, 60, WallState::kOutside);
  paint(cells, {5, 20, 25, 40}, WallState::kOn);
  paint(cells, {35, 20, 55, 40}, WallState::kOn);
  paint(cells, {25, 22, 35, 38}, WallState::kThrough);
  paint(cells, {10, 20, 20, 34}, WallState::kThrough);
  const OpenEnds gap = open_ends(cells, rectangle(25, 35, 22, 38)),
                 window = open_ends(cells, rectangle(10, 20, 20, 34)),
                 inside = open_ends(cells, rectangle(40, 50, 25, 35));
  CHECK((gap.head && gap.foot));
  CHECK((!window.head && window.foot));
  CHECK((!inside.head && !inside.foot));
  CHECK((!inside.left && !inside.right && !gap.left && !gap.right));
  paint(cells, {48, 25, 55, 35}, WallState::kEmpty);
  paint(cells, {5, 25, 12, 35}, WallState::kEmpty);
  const OpenEnds right = open_ends(cells, rectangle(48, 55, 25, 35)),
                 left = open_ends(cells, rectangle(5, 12, 25, 35));
  CHECK((right.right && !right.left && left.left && !left.right));
}

TEST_CASE("framed_share__of_steep_sides_is_that_of_the_jambs_alone") {
  WallCells cells = painted::cells_of(60, 60, WallState::kOutside);
  painted::paint(cells, {0, 0, 60, 20}, WallState::kOn);
  painted::paint(cells, {0, 40, 60, 60}, WallState::kOn);
  const OpeningShape gap = painted::rectangle(20, 40, 20, 40);
  CHECK(framed_share(cells, gap) == doctest::Approx(0.5));
  CHECK(framed_share(cells, gap, Sides::kSteep) == 0);
  painted::paint(cells, {0, 20, 20, 40}, WallState::kOn);
  CHECK(framed_share(cells, gap, Sides::kSteep) == doctest::Approx(0.5));
}
