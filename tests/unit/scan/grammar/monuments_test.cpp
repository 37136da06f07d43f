// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("monuments__wings_stand_back_or_forward_beside_a_middle_with_an_arched_door") {
  size_t forward = 0, pediments = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kWings, seed);
    REQUIRE(plan.walls.size() == 3);
    CHECK(plan.walls[0].y_m == plan.walls[2].y_m);
    CHECK(std::abs(plan.walls[0].y_m) >= 0.3 - 1e-9);
    forward += plan.walls[0].y_m < 0;
    pediments += plan.walls[1].outline.size() == 5;
    CHECK(count_of_class(plan, OpeningClass::kDoor) == 1);
    CHECK(plan.walls[1].openings[0].shape.form == Shape::Form::kArched);
    CHECK(is_orderly(plan));
  }
  CHECK(forward > 2);
  CHECK(forward < 20);
  CHECK(pediments > 15);
}

TEST_CASE("monuments__churches_have_a_portal_a_rose_and_lancets_under_a_gable") {
  size_t pointed = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kChurch, seed);
    REQUIRE(plan.walls.size() == 1);
    CHECK(plan.walls[0].outline.size() == 5);
    CHECK(count_of_class(plan, OpeningClass::kDoor) == 1);
    size_t round = 0, lancets = 0;
    for (const PlannedOpening& o : plan.walls[0].openings) {
      round += o.shape.form == Shape::Form::kRound && bounds_of_opening(o).width() > 1.3;
      const bool is_head = o.shape.form == Shape::Form::kPointed;
      pointed += is_head;
      lancets += o.opening_class == OpeningClass::kWindow &&
                 (is_head || o.shape.form == Shape::Form::kArched);
    }
    CHECK(round == 1);
    CHECK(lancets >= 2);
    CHECK(is_orderly(plan));
  }
  CHECK(pointed > 20);
}
