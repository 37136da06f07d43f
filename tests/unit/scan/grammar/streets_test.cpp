// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("streets__shops_have_fronts_signs_and_canopies") {
  size_t signs = 0, canopies = 0, flush = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kShops, seed);
    CHECK(count_of_class(plan, OpeningClass::kShopFront) >= 1);
    for (const Pad& p : plan.walls[0].pads)
      signs += p.part_class == "sign" || p.part_class == "dark";
    canopies += plan.plates.size();
    for (const PlannedOpening& o : plan.walls[0].openings)
      flush += o.opening_class == OpeningClass::kShopFront && o.depth_m < 0.06;
    CHECK(is_orderly(plan));
  }
  CHECK(signs > 30);
  CHECK(canopies > 20);
  CHECK(flush > 3);
}

TEST_CASE("streets__arcades_stand_on_the_ground_before_a_passage_with_shops") {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kArcade, seed);
    REQUIRE(plan.walls.size() == 2);
    CHECK(count_of_class(plan, OpeningClass::kRecess) >= 3);
    for (const PlannedOpening& o : plan.walls[0].openings)
      if (o.opening_class == OpeningClass::kRecess) {
        CHECK(o.shape.form == Shape::Form::kArched);
        CHECK(bounds_of_opening(o).v0 == 0);
        CHECK(o.depth_m == plan.walls[1].y_m);
      }
    CHECK(plan.walls[1].openings.size() >= 3);
    CHECK(is_orderly(plan));
  }
}

TEST_CASE("streets__factories_have_wide_windows_and_a_gate") {
  size_t vents = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kFactory, seed);
    CHECK(count_of_class(plan, OpeningClass::kGateway) == 1);
    vents += count_of_class(plan, OpeningClass::kVent);
    for (const PlannedOpening& o : plan.walls[0].openings)
      if (o.opening_class == OpeningClass::kWindow) CHECK(bounds_of_opening(o).width() > 2);
    CHECK(is_orderly(plan));
  }
  CHECK(vents > 10);
}
