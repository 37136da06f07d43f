// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "unit/scan/yard/yards.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("yard_targets__stand_where_the_list_has_them") {
  const yard::Plan one = yard_plan(YardZone::kComplete), facades = yard_plan(YardZone::kFacades);
  CHECK(targets_of(one, 1) == 4);
  CHECK(targets_of(one, 2) == 4);
  CHECK(targets_of(one, 3) == 4);
  CHECK(targets_of(one, 4) == 0);
  CHECK(targets_of(facades, 1) == 4);
  CHECK(targets_of(facades, 2) == 4);
  CHECK(targets_of(facades, 3) == 6);
  CHECK(targets_of(facades, 4) == 4);
  for (const yard::Target& t : one.targets)
    if (t.id == 116) CHECK(std::hypot(t.place.x - 89.160, t.place.y - 110.141) < 0.15);
}

TEST_CASE("yard_targets__variants_move_and_drop_them") {
  YardSettings settings;
  settings.corner_targets = settings.missing_target = true;
  const yard::Plan plan = yard::plan_of(settings, 1);
  CHECK(targets_of(plan, 2) == 3);
  CHECK(targets_of(plan, 3) == 4);
  for (const yard::Target& t : plan.targets) {
    if (t.code != 3) continue;
    double nearest = INFINITY;  // to the outer edge of a window at its end
    for (const yard::Side& side : plan.sides)
      for (const yard::Opening& o : side.openings)
        for (const double u : {o.left_m, o.right_m})
          nearest = std::min(nearest, norm(t.place - side.front_of(o).point(u, t.place.z)));
    CHECK(nearest < 0.06);
  }
}
