// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/near_wall.h"

#include <doctest/doctest.h>

#include "unit/segment/front/made_walls.h"

using namespace jalon;
using namespace jalon::test;

namespace {

FrontEvidence near(MadeWalls& m) {
  const WallGroup group{0, {0}, {}};
  const WallSheet sheet = m.sheet(group);
  FrontEvidence out;
  Task task;
  look_near(*m.cloud, {}, m.labels, m.segments, group, sheet, out, task);
  return out;
}

}  // namespace

TEST_CASE(
    "look_near__a_pane_fills_its_opening_a_sign_hangs_on_the_wall_the_ground_lies_at_its_foot") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 8, 6, is_wall);
  m.upright({3, 0.2, 2}, 1, 2, 2);
  m.upright({5.5, -0.3, 4.5}, 1, 2, 1);
  m.level({0, -4, 0}, 8, 4);
  const FrontEvidence e = near(m);
  CHECK(e.filling.behind == doctest::Approx(2.5).epsilon(0.2));  // without the cells at its edge
  CHECK(e.filling.before == 0);
  CHECK(e.hung.before == doctest::Approx(2).epsilon(0.2));
  CHECK(e.hung.behind < 0.3);
  CHECK(e.ground.before == doctest::Approx(32).epsilon(0.1));
  CHECK(e.ground.behind == 0);
}

TEST_CASE("look_near__a_wall_round_the_corner_says_nothing") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 8, 6);
  m.add({7.9, 0, 0}, {0, 1, 0}, {0, 0, 1}, 6, 6);
  const FrontEvidence e = near(m);
  CHECK(e.hung.behind == 0);
  CHECK(e.filling.behind == 0);
}
