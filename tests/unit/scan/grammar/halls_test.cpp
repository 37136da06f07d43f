// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("halls__schools_have_ribbons_of_windows_under_screens_beside_a_stair") {
  size_t screens = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kSchool, seed);
    REQUIRE(plan.walls.size() == 2);
    CHECK(plan.walls[0].y_m < 0);
    CHECK(count_of_class(plan, OpeningClass::kDoor) == 1);
    for (const PlannedOpening& o : plan.walls[1].openings) CHECK(bounds_of_opening(o).width() > 2);
    screens += !plan.blocks.empty();
    CHECK(is_orderly(plan));
  }
  CHECK(screens > 15);
  CHECK(screens < 30);
}

TEST_CASE("halls__sheds_have_a_saw_tooth_border_and_strips_of_windows_over_a_gate") {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kSheds, seed);
    const double eaves = plan.floors_m.back();
    const size_t teeth = (plan.walls[0].outline.size() - 2) / 2;
    CHECK(teeth >= 2);
    CHECK(plan.top_m() > eaves + 0.8);
    CHECK(count_of_class(plan, OpeningClass::kGateway) >= 1);
    for (const PlannedOpening& o : plan.walls[0].openings)
      if (o.opening_class == OpeningClass::kWindow) {
        CHECK(bounds_of_opening(o).v0 > 2.5);
        CHECK(bounds_of_opening(o).v1 < eaves);
      }
    CHECK(is_orderly(plan));
  }
}

TEST_CASE("halls__naves_have_lancets_between_buttresses_that_stand_well_forward") {
  size_t pointed = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kNave, seed);
    size_t lancets = 0, buttresses = 0;
    for (const PlannedOpening& o : plan.walls[0].openings) {
      pointed += o.shape.form == Shape::Form::kPointed;
      lancets += o.opening_class == OpeningClass::kWindow && bounds_of_opening(o).height() > 2;
    }
    for (const Pad& p : plan.walls[0].pads)
      buttresses += p.part_class == "buttress" && p.high_m >= 0.4 * 0.6;
    CHECK(lancets >= 2);
    CHECK(buttresses >= 4);
    CHECK(count_of_class(plan, OpeningClass::kDoor) == 1);
    CHECK(is_orderly(plan));
  }
  CHECK(pointed > 30);
}
