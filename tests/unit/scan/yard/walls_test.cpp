// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "scan/yard/sheets.h"
#include "unit/scan/yard/yards.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("yard_walls__are_corrugated_and_open_where_the_openings_are") {
  yard::Side side;
  side.wall = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  side.length_m = 4;
  side.top_m = 249.7;
  side.openings = {{false, 1, 1, 3, 247.7, 248.9, 0.17, false, false}};
  SceneBuilder builder{Transform{}};
  yard::Sheets sheets(builder);
  yard::Target target{1, 1, {}, true, yard::target_sheet(side), 0.5, 247};
  add_sheet_wall(sheets, side, {target});
  const Model model = builder.take();
  double nearest = INFINITY, farthest = -INFINITY;
  for (const Vec3& p : model.vertices) {
    nearest = std::min(nearest, p.y), farthest = std::max(farthest, p.y);
    CHECK(p.z >= yard::kGround_m);
    CHECK(p.z <= side.top_m);
  }
  CHECK(nearest == doctest::Approx(-0.025));
  CHECK(farthest == doctest::Approx(0.025));
  CHECK(std::fabs(front_y(model, 0.5, 248)) <= 0.025);
  CHECK(std::isinf(front_y(model, 2, 248)));
  CHECK(std::isinf(front_y(model, 0.46, 247.04)));  // behind the target
  CHECK(std::isfinite(front_y(model, 0.44, 247)));
  CHECK(std::isinf(front_y(model, 2, 247.64)));  // the sill's place
  CHECK(std::isfinite(front_y(model, 2, 247.62)));
  CHECK(std::isfinite(front_y(model, 2, 249)));
  // Between waves the chords stay within 2 mm of the sine.
  for (double x = 0.003; x < 1; x += 0.01)
    CHECK(std::fabs(front_y(model, x, 248) + 0.025 * std::sin(2 * std::acos(-1.0) * x / 0.2)) <
          0.002);
  for (const uint8_t c : sheets.classes()) CHECK(c == yard::kWall);
}
