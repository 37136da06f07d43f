// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/directions.h"

#include <doctest/doctest.h>

#include <set>

#include "base/error.h"

using namespace jalon;

namespace {

StaticSettings field(double h0, double h1, double v0, double v1, double step) {
  StaticSettings s;
  s.horizontal_from_rad = h0, s.horizontal_to_rad = h1;
  s.vertical_from_rad = v0, s.vertical_to_rad = v1;
  s.horizontal_step_rad = s.vertical_step_rad = step;
  return s;
}

}  // namespace

TEST_CASE("directions__a_revolution_leaves_its_end_out_and_a_column_takes_it_in") {
  constexpr double kPi = std::numbers::pi;
  // 360 degrees at 10: 36 columns, not 37; -60 to 90 degrees at 10: 16 rows with both ends.
  const RayGrid grid = ray_grid(field(-kPi, kPi, -kPi / 3, kPi / 2, kPi / 18));
  CHECK(grid.columns == 36);
  CHECK(grid.rows == 16);
  const RayGrid one = ray_grid(field(0.3, 0.3, 0.1, 0.1, 0.01));
  CHECK(one.rays() == 1);
}

TEST_CASE("directions__refuse_fields_that_end_before_they_begin_and_too_many_rays") {
  CHECK_THROWS_AS(ray_grid(field(1, 0, 0, 1, 0.1)), Error);
  CHECK_THROWS_AS(ray_grid(field(0, 1, 1, 0, 0.1)), Error);
  CHECK_THROWS_AS(ray_grid(field(0, NAN, 0, 1, 0.1)), Error);
  CHECK_THROWS_AS(ray_grid(field(-3, 3, -1.5, 1.5, 1e-6)), Error);  // 1.8e13 rays
}

TEST_CASE("directions__go_from_y_clockwise_toward_x_and_up_from_the_horizon") {
  constexpr double kQuarter = std::numbers::pi / 2;
  const StaticSettings s = field(0, 4 * kQuarter, 0, kQuarter, kQuarter);
  Task task;
  const Directions directions(s, ray_grid(s), task);
  REQUIRE(directions.grid().columns == 4);
  REQUIRE(directions.grid().rows == 2);
  const Vec3 expected[] = {{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {-1, 0, 0}};
  for (uint64_t column = 0; column < 4; ++column) {
    CHECK(norm(directions.of(2 * column) - expected[column]) < 1e-15);
    CHECK(norm(directions.of(2 * column + 1) - Vec3{0, 0, 1}) < 1e-15);
    CHECK(directions.of_horizon(2 * column) == 1);
    CHECK(std::abs(directions.of_horizon(2 * column + 1)) < 1e-15);
  }
}

TEST_CASE("directions__by_rows_are_those_by_columns_in_another_order") {
  StaticSettings s = field(-1, 1, -0.5, 0.7, 0.13);
  StaticSettings t = s;
  t.order = StaticSettings::Order::kRows;
  Task task;
  const RayGrid grid = ray_grid(s);
  const Directions columns(s, grid, task), rows(t, grid, task);
  for (uint64_t i = 0; i < grid.columns; ++i)
    for (uint64_t j = 0; j < grid.rows; ++j)
      CHECK(columns.of(i * grid.rows + j) == rows.of(j * grid.columns + i));
}

TEST_CASE("directions__errors_of_one_step_lead_to_the_neighbouring_ray") {
  const StaticSettings s = field(-1, 1, -0.5, 0.7, 0.1);
  Task task;
  const Directions directions(s, ray_grid(s), task);
  const uint64_t rows = directions.grid().rows;
  CHECK(directions.of(5, 0, 0) == directions.of(5));
  CHECK(norm(directions.of(5, 0.1, 0) - directions.of(5 + rows)) < 1e-15);
  CHECK(norm(directions.of(5, 0, 0.1) - directions.of(6)) < 1e-15);
}
