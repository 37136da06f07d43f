// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdint>

#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("sketch__leaves_out_openings_that_leave_the_wall_or_meet_others") {
  BareSketch s;
  const auto flat = [](double u0, double u1, double v0, double v1) {
    PlannedOpening o;
    o.shape = Shape::flat({u0, u1, v0, v1});
    return o;
  };
  CHECK(s.sketch.open(s.wall, flat(1, 2, 1, 2)));
  CHECK_FALSE(s.sketch.open(s.wall, flat(1.5, 2.5, 1.5, 2.5)));  // in the first
  CHECK_FALSE(s.sketch.open(s.wall, flat(2.05, 3, 1, 2)));       // less than a pier beside it
  CHECK_FALSE(s.sketch.open(s.wall, flat(9.5, 10.5, 1, 2)));     // beyond the wall
  CHECK_FALSE(s.sketch.open(s.wall, flat(9, 9.95, 1, 2)));       // at its border
  CHECK_FALSE(s.sketch.open(s.wall, flat(4, 4.2, 1, 2)));        // too narrow
  CHECK(s.sketch.open(s.wall, flat(4, 5, 0, 2)));                // a door stands on the ground
  CHECK(s.at().openings.size() == 2);
}

TEST_CASE("sketch__windows_have_the_size_of_their_style_over_their_floor") {
  BareSketch s;
  WindowStyle style;
  style.width_m = 1.2, style.height_m = 1.5, style.sill_m = 0.8, style.depth_m = 0.17;
  s.sketch.window_row(s.wall, style, s.sketch.axes(0, 10, 4), 1);
  REQUIRE(s.at().openings.size() == 4);
  for (size_t i = 0; i < 4; ++i) {
    const PlannedOpening& o = s.at().openings[i];
    const Rect box = bounds_of_opening(o);
    CHECK(box.u0 == doctest::Approx(2.5 * static_cast<double>(i) + 1.25 - 0.6));
    CHECK(box.width() == doctest::Approx(1.2));
    CHECK(box.v0 == doctest::Approx(3.8));
    CHECK(box.height() == doctest::Approx(1.5));
    CHECK(o.depth_m == 0.17);
    CHECK(o.storey == 1);
    CHECK(o.opening_class == OpeningClass::kWindow);
  }
}

TEST_CASE("sketch__doors_shops_vents_and_recesses_are_of_their_class") {
  BareSketch s;
  CHECK(s.sketch.door(s.wall, 1, 1, 2.2, 0.2));
  CHECK(s.sketch.shop_front(s.wall, 2, 5, 2.5, 0.1));
  CHECK(s.sketch.vent(s.wall, 6, 0.2, 0.6, 0.3));
  CHECK(s.sketch.niche(s.wall, 8, 1, 0.5, 0.7));
  const size_t back = s.sketch.recess(s.wall, {6, 9, 3.1, 5.5}, 1.5, 1);
  REQUIRE(back != SIZE_MAX);
  CHECK(s.plan.walls[back].y_m == doctest::Approx(1.5));
  CHECK(area_of(s.plan.walls[back].outline) == doctest::Approx(7.2));
  CHECK(s.sketch.recess(s.wall, {6, 9, 3.1, 5.5}, 1.5, 1) == SIZE_MAX);
  for (const OpeningClass c : {OpeningClass::kDoor, OpeningClass::kShopFront, OpeningClass::kVent,
                               OpeningClass::kOther, OpeningClass::kRecess})
    CHECK(count_of_class(s.plan, c) == 1);
}

TEST_CASE("sketch__finish_sets_surrounds_sills_and_shutters_where_there_is_room") {
  BareSketch s;
  PlannedOpening o;
  o.shape = Shape::flat({2, 3, 1, 2.5});
  o.surround_m = 0.15;
  CHECK(s.sketch.open(s.wall, o));
  o.surround_m = 0;
  o.has_sill = true;
  o.shape = Shape::flat({5, 6, 1, 2.5});
  o.has_shutters = true;
  CHECK(s.sketch.open(s.wall, o));
  o.shape = Shape::flat({6.6, 7.6, 1, 2.5});  // no room for its left shutter
  CHECK(s.sketch.open(s.wall, o));
  s.sketch.finish();
  const auto pads = [&](const std::string& part_class) {
    return std::count_if(s.at().pads.begin(), s.at().pads.end(),
                         [&](const Pad& p) { return p.part_class == part_class; });
  };
  CHECK(pads("surround") == 1);
  CHECK(pads("sill") == 2);
  CHECK(pads("shutter") == 3);
  CHECK(is_orderly(s.plan));
  const Pad& surround = s.at().pads.front();
  CHECK(area_of(surround.outline) - area_of(surround.holes.at(0)) ==
        doctest::Approx(1.3 * 1.8 - 1.5));
}

TEST_CASE("sketch__takes_the_length_and_the_storeys_that_are_asked_for") {
  GrammarSettings settings;
  Plan plan;
  Dice dice(1, 1);
  Sketch drawn(settings, plan, dice);
  const auto [length, floors] = drawn.sizes(6, 15, 3, 5);
  CHECK(length >= 6);
  CHECK(length <= 15);
  CHECK(floors >= 3);
  CHECK(floors <= 5);
  settings.front_m = 33, settings.floors = 2;
  CHECK(drawn.sizes(6, 15, 3, 5) == std::pair{33.0, 2});
  drawn.storeys(3, 4, 3, 0.9);
  CHECK(drawn.storey_count() == 3);
  CHECK(drawn.eaves() == doctest::Approx(4 + 3 + 2.7));
}
