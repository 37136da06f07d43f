// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("houses__have_one_door_a_house_and_windows_in_every_storey") {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kTownHouse, seed);
    CHECK(count_of_class(plan, OpeningClass::kDoor) == 1);
    for (int storey = 0; storey + 1 < static_cast<int>(plan.floors_m.size()); ++storey)
      CHECK(std::any_of(plan.walls[0].openings.begin(), plan.walls[0].openings.end(),
                        [&](const PlannedOpening& o) { return o.storey == storey; }));
    CHECK(is_orderly(plan));
  }
}

TEST_CASE("houses__of_a_terrace_stand_centimetres_or_a_step_apart_with_a_door_each") {
  int near = 0, far = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kTerrace, seed);
    CHECK(plan.walls.size() >= 3);
    CHECK(count_of_class(plan, OpeningClass::kDoor) == plan.walls.size());
    for (size_t i = 1; i < plan.walls.size(); ++i) {
      const double step = std::abs(plan.walls[i].y_m - plan.walls[0].y_m);
      (step <= 0.12 ? near : far) += 1;
      CHECK(bounds_of(plan.walls[i].outline).u0 ==
            doctest::Approx(bounds_of(plan.walls[i - 1].outline).u1));
    }
    CHECK(is_orderly(plan));
  }
  CHECK(near > far);
  CHECK(far > 0);
}

TEST_CASE("houses__gables_rise_over_their_eaves_with_round_triangular_or_sloping_windows") {
  int round = 0, triangles = 0, sloping = 0, stepped = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kGabled, seed);
    const double eaves = plan.floors_m.back();
    CHECK(plan.top_m() > eaves + 1.5);
    stepped += plan.walls[0].outline.size() > 8;
    for (const PlannedOpening& o : plan.walls[0].openings) {
      round += o.shape.form == Shape::Form::kRound;
      triangles += o.shape.form == Shape::Form::kPolygon && o.shape.corners.size() == 3;
      sloping += o.shape.form == Shape::Form::kPolygon && o.shape.corners.size() == 4;
    }
    CHECK(is_orderly(plan));
  }
  CHECK(round > 10);
  CHECK(triangles > 20);
  CHECK(sloping > 5);
  CHECK(stepped > 5);
}
