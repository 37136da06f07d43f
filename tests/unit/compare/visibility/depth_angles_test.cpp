// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Angles under which a scanner sees points, against the C library's, and the cells of a grid over them.
#include "compare/visibility/depth_angles.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"
#include "geometry/rigid_motion.h"

using namespace jalon;

TEST_CASE("depth_angles__count_from_north_clockwise_and_from_the_horizon") {
  constexpr double kQuarter = std::numbers::pi / 2, kError = 1e-10;
  struct Case {
    Vec3 p;
    double horizontal, vertical;
  };
  const Case cases[] = {{{0, 2, 0}, 0, 0},
                        {{2, 0, 0}, kQuarter, 0},
                        {{-2, 0, 0}, -kQuarter, 0},
                        {{0, 0, 2}, 0, kQuarter},
                        {{0, 0, -2}, 0, -kQuarter},
                        {{2, 2, 0}, kQuarter / 2, 0},
                        {{0, -1, -1}, 2 * kQuarter, -kQuarter / 2}};
  for (const auto& [p, horizontal, vertical] : cases) {
    const Sighting s = sighting_of(p);
    CHECK(std::fabs(s.horizontal_rad - horizontal) < kError);
    CHECK(std::fabs(s.vertical_rad - vertical) < kError);
    CHECK(s.range_m == doctest::Approx(norm(p)).epsilon(1e-15));
  }
  RandomStream random(51, 0);
  for (int k = 0; k < 20000; ++k) {
    const Vec3 p{random.normal(), random.normal(), random.normal()};
    const Sighting s = sighting_of(p);
    REQUIRE(std::fabs(s.horizontal_rad - std::atan2(p.x, p.y)) < kError);
    REQUIRE(std::fabs(s.vertical_rad - std::atan2(p.z, std::hypot(p.x, p.y))) < kError);
  }
  CHECK(sighting_of({}).range_m == 0);
}

TEST_CASE("depth_angles__of_a_block_are_those_of_its_points_one_by_one") {
  RandomStream random(52, 0);
  const Vec3 centre{652001, 6861002, 33};
  const Transform axes = rotation_by({0.2, -0.4, 1.3});
  for (const size_t n : {size_t{0}, size_t{1}, size_t{7}, SightingBlock::kPoints}) {
    std::vector<double> xyz;
    for (size_t i = 0; i < 3 * n; ++i)
      xyz.push_back(centre[static_cast<int>(i % 3)] + 20 * (random.uniform() - 0.5));
    SightingBlock block{};
    sight(xyz, centre, axes, block);
    for (size_t i = 0; i < n; ++i) {
      const Vec3 p{xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
      const Sighting one = sighting_of(axes.direction(p - centre));
      CHECK(block[i].horizontal_rad == one.horizontal_rad);
      CHECK(block[i].vertical_rad == one.vertical_rad);
      CHECK(block[i].range_m == one.range_m);
    }
  }
}

TEST_CASE("angular_grid__finds_the_cell_of_every_centre_and_what_lies_outside") {
  AngularGrid open{-3.0, -0.4, 0.1, 0.2, 12, 4, false};
  AngularGrid closed{0.3, -1, std::numbers::pi / 8, 0.5, 16, 4, true};
  for (const AngularGrid& grid : {open, closed}) {
    AngularGrid::Place place;
    for (uint32_t column = 0; column < grid.columns; ++column)
      for (uint32_t row = 0; row < grid.rows; ++row) {
        double h = grid.horizontal_of(column);
        if (h > std::numbers::pi) h -= 2 * std::numbers::pi;  // as a sighting has it
        REQUIRE(grid.locate({h, grid.vertical_of(row), 1}, place));
        CHECK(place.column == column);
        CHECK(place.row == row);
        CHECK(grid.index(place) == size_t{row} * grid.columns + column);
        CHECK(place.u == doctest::Approx(0.5).epsilon(1e-9).scale(0));
        CHECK(place.v == doctest::Approx(0.5).epsilon(1e-9).scale(0));
      }
    CHECK_FALSE(grid.locate({grid.horizontal_of(0), grid.vertical_from_rad - 1e-6, 1}, place));
    CHECK_FALSE(grid.locate({grid.horizontal_of(0), grid.vertical_of(4), 1}, place));
  }
  AngularGrid::Place place;
  CHECK_FALSE(open.locate({-3.01, 0, 1}, place));
  CHECK_FALSE(open.locate({-1.79, 0, 1}, place));
  // A closed one has no side; just left of its seam lies the last column.
  REQUIRE(closed.locate({0.299, 0, 1}, place));
  CHECK(place.column == 15);
}
