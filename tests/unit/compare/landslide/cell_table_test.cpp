// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "compare/landslide/cell_table.h"
#include "slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("cell_table__finds_cells_and_their_neighbours") {
  const Comparison made =
      compared_slopes(slope_survey(false, 1, 20000), slope_survey(true, 2, 20000));
  const CellTable cells(made);
  CHECK(is_landslide(made));
  REQUIRE(cells.size() == made.cloud->size());
  for (size_t i = 0; i < cells.size(); i += 97) {
    CHECK(cells.find(cells.column[i], cells.line[i]) == i);
    const size_t right = cells.beside(i, 1, 0);
    if (right == CellTable::kNone) continue;
    const Vec3 step = made.cloud->point(right) - made.cloud->point(i);
    CHECK(dot(step, cells.u) == doctest::Approx(cells.cell_m));
  }
  CHECK(cells.find(-1, 0) == CellTable::kNone);
  CHECK(cells.find(int64_t{1} << 40, 0) == CellTable::kNone);
  const Vec3 corner = cells.corner(0, 0, 0);
  CHECK(dot(cells.first - corner, cells.u) == doctest::Approx(cells.cell_m / 2));
}

TEST_CASE("cell_table__refuses_what_method_landslide_does_not_make") {
  Comparison made = compared_slopes(slope_survey(false, 1, 20000), slope_survey(true, 2, 20000));
  Comparison other = made;
  other.summary = {};
  CHECK_THROWS_AS(CellTable{other}, Error);
  other = made;
  std::vector<uint32_t> zones(made.cloud->size(), UINT32_MAX);
  other.points.set(make_column<uint32_t>({"zone", ElementType::kUint32, 1, "", ""}, zones));
  CHECK_THROWS_AS(CellTable{other}, Error);
  other = made;
  other.points.set(make_column<uint32_t>({"column", ElementType::kUint32, 1, "", ""}, zones));
  CHECK_THROWS_AS(CellTable{other}, Error);
}
