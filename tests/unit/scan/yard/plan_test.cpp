// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/yard/plan.h"

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/polygon2.h"
#include "unit/scan/yard/yards.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("yard_plan__zones_have_the_openings_of_the_template") {
  const yard::Plan all = yard_plan(YardZone::kAll), one = yard_plan(YardZone::kComplete),
                   facades = yard_plan(YardZone::kFacades);
  CHECK(all.sides.size() == 24);
  CHECK(openings_of(all, true) + openings_of(all, false) == 117);
  CHECK(openings_of(one, true) == 4);  // 4 doors, 21 windows: sub-cloud 1 of the source
  CHECK(openings_of(one, false) == 21);
  CHECK(openings_of(facades, true) == 4);
  CHECK(facades.gutters.size() == 6);
  CHECK(one.gutters.empty());
}

TEST_CASE("yard_plan__openings_lie_within_their_walls_and_look_outward") {
  for (const yard::Side& side : yard_plan(YardZone::kAll).sides) {
    const Vec3 before = side.wall.point(side.length_m / 2, 0, 0.5);
    for (const yard::Building& b : yard_plan(YardZone::kAll).buildings)
      if (b.name == side.building) CHECK(!contains(b.outline, {before.x, before.y}));
    for (const yard::Opening& o : side.openings) {
      CHECK(o.left_m > 0);
      CHECK(o.right_m < side.length_m);
      CHECK(o.high_m < side.top_m);
      CHECK(o.depth_m >= 0.01);
    }
  }
}

TEST_CASE("yard_plan__the_seed_opens_two_windows_and_shades_about_a_third") {
  size_t open = 0, shaded = 0, windows = 0;
  for (uint64_t seed = 1; seed <= 10; ++seed)
    for (const yard::Side& side : yard_plan(YardZone::kComplete, seed).sides)
      for (const yard::Opening& o : side.openings) {
        open += o.is_half_open;
        shaded += o.has_blind;
        windows += !o.is_door;
        if (!o.is_half_open) continue;
        const Frame front = side.front_of(o);
        CHECK(norm(front.point(o.left_m, 1) - side.wall.point(o.left_m, 1, -o.depth_m)) < 1e-9);
        CHECK(dot(front.normal(), side.wall.normal()) == doctest::Approx(std::cos(0.2618)));
      }
  CHECK(open == 20);
  CHECK(std::fabs(static_cast<double>(shaded) / static_cast<double>(windows) - 1.0 / 3) < 0.1);
}

TEST_CASE("yard_plan__flush_doors_stand_in_their_wall") {
  YardSettings settings;
  settings.zone = YardZone::kFacades;
  settings.flush_doors = true;
  for (const yard::Side& side : yard::plan_of(settings, 1).sides)
    for (const yard::Opening& o : side.openings)
      if (o.is_door) CHECK((o.depth_m == 0) == (side.building == 'A'));
}
