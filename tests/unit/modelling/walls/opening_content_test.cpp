// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/opening_content.h"

#include <doctest/doctest.h>

#include "unit/modelling/plane_rings.h"

using namespace rings;

TEST_CASE("opening_content__counts_cells_with_joinery_with_what_lies_behind_and_with_nothing") {
  WallMap map;
  map.origin = {0, 0};
  map.cell_m = 0.1;
  map.columns = map.rows = 40;
  FacadeOpening opening;
  opening.outline = rectangle({1, 1}, {2, 2});  // 100 cells
  opening.depth_m = 0.2;
  HoleSurvey survey;
  const auto add = [&](int column, int row, double w) {
    survey.points.push_back({0, 1, static_cast<float>(1.05 + 0.1 * column),
                             static_cast<float>(1.05 + 0.1 * row), static_cast<float>(w)});
  };
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 10; ++column) add(column, row, -0.2);  // a parapet
  for (int column = 0; column < 10; ++column) {
    add(column, 0, -0.21);  // once more where it is
    add(column, 7, -0.6);   // seen through the pane
    add(column, -3, -0.2);  // below the opening
    add(column, 8, -0.05);  // a blind before the frame
  }
  const OpeningContent told = opening_content(survey, map, opening, 0.03);
  CHECK(told.joinery == doctest::Approx(0.4));
  CHECK(told.behind == doctest::Approx(0.1));
  CHECK(told.empty == doctest::Approx(0.4));
  const OpeningContent nothing = opening_content({}, map, opening, 0.03);
  CHECK(nothing.joinery == 0);
  CHECK(nothing.empty == 1);
}
