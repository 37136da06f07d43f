// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Rows and columns of a wall's openings.
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "modelling/patterns/grid.h"
#include "modelling/patterns/patterns.h"
#include "unit/modelling/pattern_walls.h"

using namespace jalon;
using namespace jalon::test;

namespace {

OpeningGrid grid_of(const FacadeWall& wall) {
  std::vector<RingBox> boxes;
  for (const FacadeOpening& o : wall.openings) boxes.push_back(ring_box(o.outline));
  std::vector<size_t> all(boxes.size());
  std::iota(all.begin(), all.end(), size_t{0});
  return find_grid(wall, all, boxes, {});
}

DrawnWall field(size_t rows, size_t columns, double pitch_m = 2.5) {
  DrawnWall out(pitch_m * static_cast<double>(columns) + 1, 3 * static_cast<double>(rows) + 1, 0.04,
                5);
  for (size_t r = 0; r < rows; ++r)
    for (size_t c = 0; c < columns; ++c)
      out.add({1 + pitch_m * static_cast<double>(c), 1 + 3 * static_cast<double>(r)}, {1, 1.5});
  return out;
}

}  // namespace

TEST_CASE("opening_grid__of_a_field_has_a_line_a_row_and_column_at_the_mean_of_its_middles") {
  DrawnWall drawn = field(3, 4);
  drawn.hide(5);
  const OpeningGrid grid = grid_of(drawn.wall());
  REQUIRE(grid.rows.size() == 3);
  REQUIRE(grid.columns.size() == 4);
  for (size_t r = 0; r < 3; ++r) {
    CHECK(std::fabs(grid.rows[r].at - (1.75 + 3 * static_cast<double>(r))) < 0.01);
    CHECK(grid.rows[r].openings.size() == (r == 1 ? 3 : 4));
  }
  for (size_t c = 0; c < 4; ++c)
    CHECK(std::fabs(grid.columns[c].at - (1.5 + 2.5 * static_cast<double>(c))) < 0.01);
  CHECK(grid.sigma_m > 0);
  CHECK(grid.sigma_m < 0.02);
  CHECK(grid.row_near(1.8, 0.1) == &grid.rows[0]);
  CHECK(grid.row_near(2.5, 0.1) == nullptr);
  CHECK(grid.column_near(4.1, 0.2) == &grid.columns[1]);
}

TEST_CASE("opening_grid__a_row_at_equal_distances_gets_columns_for_its_gaps") {
  DrawnWall drawn = field(1, 6);
  drawn.hide(2);
  const OpeningGrid grid = grid_of(drawn.wall());
  REQUIRE(grid.rows.size() == 1);
  REQUIRE(grid.columns.size() == 6);
  CHECK(grid.columns[2].openings.empty());
  CHECK(std::fabs(grid.columns[2].at - 6.5) < 0.02);
  CHECK(grid_of(field(1, 3).wall()).rows.empty());  // three are no row
}

TEST_CASE("opening_grid__few_openings_bare_crossings_and_chance_make_none") {
  CHECK(grid_of(field(2, 1).wall()).rows.empty());
  CHECK(find_grid(field(2, 2).wall(), {}, {}, {}).rows.empty());
  DrawnWall scattered(20, 12, 0.04, 6);
  const Vec2 places[] = {{1, 1}, {4.3, 2.9}, {8.1, 1.7}, {11.9, 6.3}, {15.2, 4.1}, {17.5, 8.8}};
  for (const Vec2& p : places) scattered.add(p, {1, 1.5});
  CHECK(grid_of(scattered.wall()).rows.empty());
  // A row of one opening above bare wall is left out.
  DrawnWall odd = field(2, 4);
  FacadeWall wall = odd.wall();
  DrawnWall taller(11, 12, 0.04, 5);
  for (const Rectangle& r : odd.truth) taller.add(r.low, r.size);
  taller.add({1, 9}, {1, 1.5});
  CHECK(grid_of(taller.wall()).rows.size() == 2);
}

TEST_CASE("opening_grid__the_pattern_at_a_crossing_is_that_of_most_of_its_row_and_column") {
  std::vector<Pattern> patterns(2);
  patterns[0].members = {0, 1, 2};
  patterns[1].members = {3, 4, 5, 6};
  CHECK(pattern_at(patterns, {0, {0, 1, 3}}, {0, {2, 4}}) == 0);
  CHECK(pattern_at(patterns, {0, {0, 3}}, {0, {4, 5}}) == 1);
  CHECK(pattern_at(patterns, {0, {0}}, {0, {3, 4, 5}}) == 0);  // it must be in the row
  CHECK(pattern_at(patterns, {0, {}}, {0, {3}}) == 1);
  CHECK(pattern_at(patterns, {0, {9}}, {0, {3}}) == 2);
}
