// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <set>

#include "base/error.h"
#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("plan__of_any_kind_is_each_of_the_kinds_by_the_seed") {
  std::set<FacadeKind> kinds;
  for (uint64_t seed = 1; seed <= 200; ++seed) kinds.insert(plan_facade({}, seed).kind);
  CHECK(kinds.size() == kDrawnKinds);
  for (const FacadeKind kind : all_kinds()) CHECK(planned(kind, 1).kind == kind);
}

TEST_CASE("plan__takes_length_storeys_and_gaps_as_told") {
  for (const FacadeKind kind : all_kinds()) {
    CAPTURE(static_cast<int>(kind));
    const Plan plan = planned(kind, 5, {.front_m = 17, .floors = 2, .gaps = BySeed::kYes});
    CHECK(plan.width_m == 17);
    CHECK(plan.has_gaps);
    CHECK_FALSE(planned(kind, 5, {.gaps = BySeed::kNo}).has_gaps);
    double right = 0;
    for (const PlannedWall& wall : plan.walls) right = std::max(right, bounds_of(wall.outline).u1);
    CHECK(right == doctest::Approx(17));
    const bool is_hall =
        kind == FacadeKind::kChurch || kind == FacadeKind::kSheds || kind == FacadeKind::kNave;
    if (!is_hall) CHECK(plan.floors_m.size() == 3);
  }
}

TEST_CASE("plan__has_openings_for_every_kind_at_the_ends_of_its_parameters") {
  for (const FacadeKind kind : all_kinds())
    for (const double front_m : {4.0, 60.0})
      for (const int64_t floors : {1, 12}) {
        CAPTURE(static_cast<int>(kind));
        CAPTURE(front_m);
        const Plan plan = planned(kind, 3, {.front_m = front_m, .floors = floors});
        CHECK(openings_of(plan) >= 1);
        CHECK(is_orderly(plan));
      }
  CHECK_THROWS_AS(planned(FacadeKind::kShops, 1, {.front_m = 3.9}), Error);
}

TEST_CASE("plan__rooms_end_behind_everything_that_is_set_back") {
  for (const FacadeKind kind : all_kinds())
    for (uint64_t seed = 1; seed <= 5; ++seed) {
      const Plan plan = planned(kind, seed);
      CHECK(plan.rooms_to_m >= plan.rooms_from_m + 2);
      for (const PlannedWall& wall : plan.walls) CHECK(wall.y_m + 0.5 < plan.rooms_to_m);
    }
}
