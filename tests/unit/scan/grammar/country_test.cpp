// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("country__timbered_storeys_stand_out_over_one_another_with_posts_and_braces") {
  size_t jettied = 0, braces = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kTimbered, seed);
    REQUIRE(plan.walls.size() + 1 == plan.floors_m.size());
    CHECK(count_of_class(plan, OpeningClass::kDoor) <= 1);
    jettied += plan.walls.back().y_m < -0.09;
    for (const PlannedWall& wall : plan.walls)
      for (const Pad& p : wall.pads)
        braces += p.part_class == "timber" && p.outline[0].at.u != p.outline[3].at.u;
    for (size_t i = 1; i < plan.walls.size(); ++i)
      CHECK(plan.walls[i].y_m <= plan.walls[i - 1].y_m);
    CHECK(is_orderly(plan));
  }
  CHECK(jettied > 8);
  CHECK(jettied < 28);
  CHECK(braces > 30);
}

TEST_CASE("country__villas_have_a_gabled_part_a_bay_window_and_open_shutters") {
  size_t bays = 0, shutters = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kVilla, seed);
    CHECK(plan.walls[0].outline.size() == 5);
    CHECK(plan.walls[0].y_m < plan.walls[1].y_m);
    CHECK(count_of_class(plan, OpeningClass::kDoor) <= 1);
    if (plan.walls.size() == 3) {
      ++bays;
      CHECK(plan.walls[2].y_m < 0);
      CHECK(plan.walls[1].outline.size() == 8);  // no wall behind it
    }
    shutters += count_of_pads(plan, "shutter");
    CHECK(is_orderly(plan));
  }
  CHECK(bays > 20);
  CHECK(shutters > 60);
}
