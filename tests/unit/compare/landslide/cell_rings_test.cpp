// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "compare/landslide/cell_rings.h"
#include "geometry/polygon2.h"
#include "slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double ring_area(const CellPiece& piece) {
  double area = signed_area(piece.outline);
  for (const auto& opening : piece.openings) area += signed_area(opening);
  return area;
}

}  // namespace

TEST_CASE("cell_rings__outline_pieces_and_leave_out_what_they_enclose") {
  const Comparison made =
      compared_slopes(slope_survey(false, 1, 20000), slope_survey(false, 2, 20000));
  const CellTable cells(made);
  // A frame of 5 x 5 about one cell, and one that touches its corner only.
  const auto belongs = [&](size_t row) {
    const uint32_t c = cells.column[row], r = cells.line[row];
    if (c == 15 && r == 15) return true;
    return c >= 10 && c < 15 && r >= 10 && r < 15 && !(c == 12 && r == 12);
  };
  const std::vector<CellPiece> pieces = cell_pieces(cells, belongs, 1);
  REQUIRE(pieces.size() == 2);
  CHECK(pieces[0].rows.size() == 24);
  REQUIRE(pieces[0].openings.size() == 1);
  CHECK(signed_area(pieces[0].outline) == doctest::Approx(24.5));  // 25 less its corners
  CHECK(signed_area(pieces[0].openings[0]) == doctest::Approx(-0.5));
  CHECK(ring_area(pieces[1]) == doctest::Approx(0.5));
  CHECK(is_simple(pieces[0].outline));
  CHECK(pieces[0].outline.size() == 8);
  CHECK(cell_pieces(cells, belongs, 2).size() == 1);
}

TEST_CASE("cell_rings__cells_that_touch_inside_a_piece_make_simple_rings") {
  const Comparison made =
      compared_slopes(slope_survey(false, 1, 20000), slope_survey(false, 2, 20000));
  const CellTable cells(made);
  // Two holes that touch at a corner.
  const auto belongs = [&](size_t row) {
    const uint32_t c = cells.column[row], r = cells.line[row];
    const bool hole = (c == 12 && r == 12) || (c == 13 && r == 13);
    return c >= 10 && c < 16 && r >= 10 && r < 16 && !hole;
  };
  const std::vector<CellPiece> pieces = cell_pieces(cells, belongs, 1);
  REQUIRE(pieces.size() == 1);
  double openings = 0;
  for (const auto& opening : pieces[0].openings) openings += signed_area(opening);
  CHECK(openings <= -1);
  CHECK(openings >= -2);
}
