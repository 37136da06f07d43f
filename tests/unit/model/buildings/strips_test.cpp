// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "model/buildings/facades.h"
#include "unit/model/buildings/houses.h"

using namespace jalon;

TEST_CASE("strip_cuts__by_both_rules__give_the_rest_to_whom_they_say") {
  using Cuts = std::vector<double>;
  CHECK(strip_cuts(2, 5, 1.5, StripRemainder::kKeep) == Cuts{2, 3.5, 5});
  CHECK(strip_cuts(0, 3.75, 1.5, StripRemainder::kKeep) ==
        Cuts{0, 1.5, 3, 3.75});                                                // half a width stays
  CHECK(strip_cuts(0, 3.7, 1.5, StripRemainder::kKeep) == Cuts{0, 1.5, 3.7});  // less is added
  CHECK(strip_cuts(0, 0.4, 1.5, StripRemainder::kKeep) == Cuts{0, 0.4});
  CHECK(strip_cuts(0, 4, 1.5, StripRemainder::kEqual) == Cuts{0, 4.0 / 3, 8.0 / 3, 4});
  CHECK(strip_cuts(0, 0.4, 1.5, StripRemainder::kEqual) == Cuts{0, 0.4});
}

TEST_CASE("strips__clipped_to_a_facade_with_a_gap__leave_out_what_is_not_there") {
  Model model;
  model.parts.push_back({"walls", "mesh", kNoParent});
  // A bridge between two walls of one plane: two boxes joined by a beam above.
  add_wall(model, {{0, 0, 0}, {2, 0, 0}, {2, 0, 5}, {0, 0, 5}}, 0, false);
  add_wall(model, {{2, 0, 4}, {6, 0, 4}, {6, 0, 5}, {2, 0, 5}}, 0, false);
  add_wall(model, {{6, 0, 0}, {8, 0, 0}, {8, 0, 5}, {6, 0, 5}}, 0, false);
  const auto facades = facades_of(vertical_pieces(model, 0.1), 0.1);
  // Corners meet, so that all six triangles are of one building and one facade.
  REQUIRE(facades.size() == 1);
  BuildingSettings settings;
  settings.width_m = 2, settings.top = StripTop::kClip;
  const auto strips = strips_of(facades[0], 3, settings);
  REQUIRE(strips.size() == 4);
  double lowest = 10;
  for (const auto& outline : strips[1].outlines)
    for (const Vec2& p : outline) lowest = std::min(lowest, p.v);
  CHECK(lowest == doctest::Approx(4));
  CHECK(strips[0].facade == 3);
}
