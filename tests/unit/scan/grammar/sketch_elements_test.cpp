// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <set>

#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("sketch__bands_run_along_the_wall_between_the_openings") {
  BareSketch s;
  CHECK(s.sketch.door(s.wall, 3, 1, 2.2, 0.2));
  s.sketch.band(s.wall, "base_course", 0, 0.5, 0.04);
  REQUIRE(s.at().pads.size() == 2);
  double length = 0;
  for (const Pad& p : s.at().pads) {
    length += bounds_of(p.outline).width();
    CHECK(p.high_m == 0.04);
  }
  CHECK(length == doctest::Approx(9).epsilon(1e-5));
  s.sketch.cornice(s.wall, 6);
  CHECK(s.at().pads.size() == 3);
  CHECK(bounds_of(s.at().pads.back().outline).v1 == doctest::Approx(6));
  CHECK(is_orderly(s.plan));
}

TEST_CASE("sketch__balconies_stand_before_the_wall_with_a_parapet_or_bars") {
  for (const bool is_solid : {true, false}) {
    BareSketch s;
    s.sketch.balcony(s.wall, 2, 4, 3, 1.2, is_solid);
    CHECK((s.plan.blocks.size() > 10) == !is_solid);
    double top = 0;
    for (const Block& b : s.plan.blocks) {
      CHECK(b.corner.y >= -1.2 - 1e-9);
      CHECK(b.corner.y + b.size.y < 0);
      CHECK(b.corner.x >= 2 - 1e-9);
      CHECK(b.corner.x + b.size.x <= 4 + 1e-9);
      top = std::max(top, b.corner.z + b.size.z);
    }
    CHECK(top == doctest::Approx(is_solid ? 4 : 4.04));
  }
}

TEST_CASE("sketch__joints_close_the_step_between_two_walls_and_look_outward") {
  for (const double back : {0.5, -0.5}) {
    BareSketch s;
    s.sketch.joint(5, 0, back, 6);  // the left wall on y = 0
    REQUIRE(s.plan.plates.size() == 1);
    const Plate& p = s.plan.plates[0];
    CHECK(p.frame.normal() == Vec3{back > 0 ? 1.0 : -1.0, 0, 0});
    CHECK(p.rect.width() * p.rect.height() == doctest::Approx(3));
    CHECK(p.frame.origin.y == std::min(0.0, back));
  }
  BareSketch flush;
  flush.sketch.joint(5, 0, 0, 6);
  CHECK(flush.plan.plates.empty());
}

TEST_CASE("sketch__signs_and_canopies_are_dark_only_where_gaps_are_wanted") {
  for (const bool has_gaps : {true, false}) {
    BareSketch s;
    s.plan.has_gaps = has_gaps;
    size_t dark = 0;
    for (int i = 0; i < 20; ++i) {
      s.sketch.sign(s.wall, 0.45 * i, 0.45 * i + 0.4, 2.5, 3);
      s.sketch.canopy(s.wall, 0.45 * i, 0.45 * i + 0.4, 3.2, 1);
    }
    for (const Pad& p : s.at().pads) dark += p.part_class == "dark";
    for (const Plate& p : s.plan.plates) {
      dark += p.part_class == "dark";
      CHECK(p.frame.normal().z > 0);
      CHECK(p.frame.point(0, p.rect.v1).y < -0.9);
    }
    CHECK((dark > 0) == has_gaps);
    CHECK(dark < 40);
  }
}

TEST_CASE("sketch__corner_stones_roofs_pipes_and_clutter_stand_clear_of_openings") {
  BareSketch s;
  WindowStyle style;
  for (const int storey : {0, 1})
    s.sketch.window_row(s.wall, style, s.sketch.axes(0, 10, 5), storey);
  s.sketch.quoins(s.wall, 6);
  CHECK(s.at().pads.size() > 20);
  std::set<std::string> things;
  for (int i = 0; i < 30; ++i) s.sketch.clutter(s.wall, 4);
  for (const Block& b : s.plan.blocks) {
    things.insert(b.part_class);
    CHECK(b.corner.y + b.size.y < 0);
    for (const PlannedOpening& o : s.at().openings) {
      const Rect box = bounds_of_opening(o);
      const bool beside = b.corner.x >= box.u1 || b.corner.x + b.size.x <= box.u0 ||
                          b.corner.z >= box.v1 || b.corner.z + b.size.z <= box.v0;
      CHECK(beside);
    }
  }
  CHECK(things.size() >= 4);
  s.sketch.drainpipe(s.wall, 5, 6);
  REQUIRE(s.plan.pipes.size() == 1);
  CHECK(s.plan.pipes[0].foot.y + s.plan.pipes[0].radius_m < 0);
  s.sketch.roof(0, 10, 6, 0);
  CHECK(s.plan.plates.back().frame.normal().z > 0.5);
  CHECK(s.plan.plates.back().frame.normal().y < -0.4);
}
