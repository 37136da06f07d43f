// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/overlap/occupied_cells.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/compare/overlap/overlap_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("occupied_cells__are_about_places_at_most_a_cell_away") {
  const OccupiedCells cells({{0.5, 0.5, 0.5}, {0.6, 0.5, 0.5}}, 1);
  CHECK(cells.size() == 1);
  CHECK(cells.are_about({-0.5, 1.9, 0}));
  CHECK_FALSE(cells.are_about({2.1, 0.5, 0.5}));
  CHECK_FALSE(cells.are_about({-1.1, 0.5, 0.5}));
}

TEST_CASE("occupied_cells__share_of_a_line_that_lies_by_half_on_another") {
  std::vector<Vec3> line, half;
  for (int k = 0; k < 100; ++k) line.push_back({k + 0.5, 0, 0}), half.push_back({k + 50.5, 0, 0});
  const OccupiedCells a(line, 1), b(half, 1);
  CHECK(a.share_in(b) == doctest::Approx(0.51));
  CHECK(a.share_in(OccupiedCells({}, 1)) == 0);
  CHECK(OccupiedCells({}, 1).share_in(a) == 0);
}

TEST_CASE("cell_of__holds_coordinates_of_any_size") {
  CHECK(cell_of({-0.5, 1e300, -1e300}, 1) == GridCell{-1, 9000000000000000, -9000000000000000});
}

TEST_CASE("sampled_points__of_a_large_cloud_are_even_and_few") {
  const std::vector<Vec3> few = sampled_points(cloud_by(hall_points(1, 200000)));
  CHECK(few.size() <= 50000);
  CHECK(few.size() > 30000);
  CHECK(sampled_points(cloud_by(hall_points(1, 500))).size() == 500);
}
