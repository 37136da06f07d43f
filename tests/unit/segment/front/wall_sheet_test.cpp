// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/wall_sheet.h"

#include <doctest/doctest.h>

#include "unit/segment/front/made_walls.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("wall_sheet__tells_the_measured_wall_from_its_openings_and_what_is_outside") {
  MadeWalls m;
  m.upright({10, 5, 3}, 1, 8, 6, is_wall);
  const WallSheet sheet = m.sheet({0, {0}, {}});
  CHECK(sheet.cell_m() == doctest::Approx(0.15).epsilon(0.01).scale(0));
  CHECK(sheet.right() - sheet.left() == doctest::Approx(8).epsilon(0.03));
  CHECK(sheet.top() - sheet.foot() == doctest::Approx(6).epsilon(0.03));
  const auto cell_at = [&](double a, double b) {
    const WallPlace p = sheet.place_of({10 + a, 4, 3 + b});
    CHECK(p.d == doctest::Approx(1));
    return sheet.cell_of(p.u, p.v);
  };
  CHECK(sheet.is_solid(cell_at(1, 1)));
  CHECK(sheet.is_solid(cell_at(7, 5)));
  CHECK(sheet.is_open(cell_at(4, 3)));
  CHECK(!sheet.is_open(cell_at(1, 1)));
  CHECK(!sheet.is_solid(cell_at(4, 3)));
  CHECK(cell_at(-1, 3) == sheet.cells());
  CHECK(cell_at(4, 7) == sheet.cells());
  const Vec3 p = sheet.point_of(sheet.place_of({11, 2, 4}));
  CHECK(norm(p - Vec3{11, 2, 4}) < 1e-9);
}

TEST_CASE("wall_sheet__what_lies_above_a_gable_or_beside_it_is_no_opening") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 8, 8, [](double a, double b) { return b < 8 - 2 * std::fabs(a - 4); });
  const WallSheet sheet = m.sheet({0, {0}, {}});
  size_t open = 0;
  for (size_t cell = 0; cell < sheet.cells(); ++cell) open += sheet.is_open(cell);
  CHECK(open == 0);
}
