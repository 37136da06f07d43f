// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("trades__mills_have_broad_arched_windows_between_lesenes_and_one_gateway") {
  size_t lesenes = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kMill, seed);
    CHECK(count_of_class(plan, OpeningClass::kGateway) == 1);
    CHECK(count_of_class(plan, OpeningClass::kWindow) >= 6);
    for (const PlannedOpening& o : plan.walls[0].openings) {
      CHECK(o.shape.form == Shape::Form::kArched);
      if (o.opening_class == OpeningClass::kWindow) CHECK(o.shape.rect.width() >= 1.3);
    }
    lesenes += count_of_pads(plan, "pilaster");
    CHECK(is_orderly(plan));
  }
  CHECK(lesenes > 60);
}

TEST_CASE("trades__inns_have_shutters_open_beside_their_windows_and_an_arched_door") {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kInn, seed);
    CHECK(count_of_class(plan, OpeningClass::kDoor) == 1);
    const size_t windows = count_of_class(plan, OpeningClass::kWindow);
    CHECK(windows >= 3);
    CHECK(count_of_pads(plan, "shutter") >= windows);
    CHECK(is_orderly(plan));
  }
}

TEST_CASE("trades__parades_have_shops_along_the_street_and_fins_between_the_windows_above") {
  size_t awnings = 0, fins = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kParade, seed);
    CHECK(count_of_class(plan, OpeningClass::kShopFront) >= 2);
    CHECK(count_of_class(plan, OpeningClass::kWindow) >= 3);
    awnings += plan.plates.size();
    fins += count_of_pads(plan, "fin");
    CHECK(is_orderly(plan));
  }
  CHECK(awnings > 40);
  CHECK(fins > 60);
}
