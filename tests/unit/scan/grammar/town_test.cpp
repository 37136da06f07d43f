// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("town__warehouses_have_loading_doors_above_each_other_and_segmental_arches") {
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kWarehouse, seed);
    const size_t storeys = plan.floors_m.size() - 1;
    CHECK(count_of_class(plan, OpeningClass::kGateway) == 1);
    CHECK(count_of_class(plan, OpeningClass::kDoor) == storeys);  // one of them in the gable
    size_t windows = 0;
    for (const PlannedOpening& o : plan.walls[0].openings) {
      if (o.opening_class == OpeningClass::kDoor)
        CHECK((bounds_of_opening(o).u0 + bounds_of_opening(o).u1) / 2 ==
              doctest::Approx(plan.width_m / 2));
      if (o.opening_class != OpeningClass::kWindow) continue;
      ++windows;
      CHECK(o.shape.form == Shape::Form::kArched);
      CHECK(o.shape.rise_m < 0.25 * o.shape.rect.width());
    }
    CHECK(windows >= storeys);
    CHECK(is_orderly(plan));
  }
}

TEST_CASE("town__staggered_windows_have_three_sizes_and_no_common_axes") {
  size_t recesses = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kStaggered, seed);
    std::set<long> axes;
    size_t windows = 0;
    for (const PlannedOpening& o : plan.walls[0].openings) {
      recesses += o.opening_class == OpeningClass::kRecess;
      if (o.opening_class != OpeningClass::kWindow) continue;
      ++windows;
      axes.insert(std::lround(50 * (bounds_of_opening(o).u0 + bounds_of_opening(o).u1)));
    }
    CHECK(windows >= 5);
    CHECK(axes.size() > 0.8 * static_cast<double>(windows));
    CHECK(is_orderly(plan));
  }
  CHECK(recesses > 30);
}

TEST_CASE("town__corner_houses_have_an_oriel_over_shops_beside_a_cut_corner") {
  size_t shops = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kCorner, seed);
    REQUIRE(plan.walls.size() == 2);
    CHECK(plan.walls[1].y_m < -0.4);
    CHECK(plan.walls[1].openings.size() >= 4);
    CHECK(bounds_of(plan.walls[1].outline).v0 > 3.4);
    shops += count_of_class(plan, OpeningClass::kShopFront);
    bool is_cut = false;
    for (const Plate& p : plan.plates) is_cut |= p.part_class == "corner" && p.frame.u.y > 0.7;
    CHECK(is_cut);
    CHECK(is_orderly(plan));
  }
  CHECK(shops > 40);
}
