// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

namespace {

size_t blocks_of(const Plan& plan, const std::string& part_class) {
  return static_cast<size_t>(
      std::count_if(plan.blocks.begin(), plan.blocks.end(),
                    [&](const Block& b) { return b.part_class == part_class; }));
}

}  // namespace

TEST_CASE("blocks__of_flats_have_balconies_blinds_and_an_entrance") {
  size_t balconies = 0, blinds = 0, garages = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kApartments, seed);
    CHECK(count_of_class(plan, OpeningClass::kDoor) == 1);
    CHECK(openings_of(plan) >= 12);
    balconies += blocks_of(plan, "balcony");
    garages += count_of_class(plan, OpeningClass::kGateway);
    for (const PlannedOpening& o : plan.walls[0].openings) blinds += o.filling.blind_share > 0;
    CHECK(is_orderly(plan));
  }
  CHECK(balconies > 60);
  CHECK(blinds > 60);
  CHECK(garages > 10);
}

TEST_CASE("blocks__of_offices_have_mullions_and_panels_three_to_five_centimetres_proud") {
  size_t panels = 0, ribbons = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kOffices, seed);
    for (const Pad& p : plan.walls[0].pads)
      if (p.part_class == "panel") {
        ++panels;
        CHECK(p.high_m >= 0.03);
        CHECK(p.high_m <= 0.05);
      }
    for (const PlannedOpening& o : plan.walls[0].openings)
      if (o.opening_class == OpeningClass::kWindow) {
        CHECK(o.filling.mullions >= 1);
        ribbons += bounds_of_opening(o).width() > 4;
      }
    CHECK(is_orderly(plan));
  }
  CHECK(panels > 100);
  CHECK(ribbons > 20);
}

TEST_CASE("blocks__loggias_have_back_walls_with_windows_of_their_own") {
  size_t recesses = 0, gateways = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kLoggias, seed);
    const size_t own = count_of_class(plan, OpeningClass::kRecess);
    recesses += own;
    gateways += count_of_class(plan, OpeningClass::kGateway);
    REQUIRE(plan.walls.size() == 1 + own);
    for (size_t w = 1; w < plan.walls.size(); ++w) {
      CHECK(plan.walls[w].y_m >= 1);
      CHECK(plan.walls[w].y_m < plan.rooms_from_m);
      CHECK(plan.walls[w].openings.size() == 1);
    }
    CHECK(is_orderly(plan));
  }
  CHECK(recesses > 40);
  CHECK(gateways > 12);
}

TEST_CASE("blocks__mansards_have_arches_below_a_long_balcony_and_dormers") {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Plan plan = planned(FacadeKind::kMansard, seed);
    CHECK(count_of_class(plan, OpeningClass::kShopFront) +
              count_of_class(plan, OpeningClass::kGateway) >=
          2);
    CHECK(plan.walls.size() >= 4);
    for (size_t w = 1; w < plan.walls.size(); ++w) {
      CHECK(plan.walls[w].y_m > 0);
      CHECK(plan.walls[w].openings.size() == 1);
      CHECK(bounds_of(plan.walls[w].outline).v0 == plan.floors_m.back());
    }
    CHECK(blocks_of(plan, "railing") > 50);
    CHECK(is_orderly(plan));
  }
}
