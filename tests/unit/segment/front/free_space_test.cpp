// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/free_space.h"

#include <doctest/doctest.h>

#include "unit/segment/front/made_walls.h"

using namespace jalon;
using namespace jalon::test;

namespace {

FrontEvidence seen(MadeWalls& m) {
  const WallSheet sheet = m.sheet({0, {0}, {}});
  Task task;
  FrontEvidence out;
  look_through(sparse_places(*m.cloud, {}, task), sheet, out, task);
  return out;
}

}  // namespace

TEST_CASE("look_through__who_stands_behind_a_wall_cannot_have_seen_the_street_before_it") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 12, 6, is_wall);
  m.level({2, -8, 0}, 8, 7);
  const FrontEvidence e = seen(m);
  CHECK(e.blocked.behind > 5);  // the rest might be seen past its ends
  CHECK(e.blocked.before == 0);
  CHECK(e.reach.before == doctest::Approx(56).epsilon(0.1));
  CHECK(e.reach.behind == 0);
}

TEST_CASE("look_through__what_is_seen_of_a_room_through_a_window_is_not_blocked") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 12, 6, is_wall);
  // What an eye at (4, -6, 1.7) sees through the window on a wall 3 m behind it.
  m.upright({0, 3, 0}, 1, 12, 9, [](double a, double b) {
    return is_window(4 + (a - 4) * 2 / 3, 1.7 + (b - 1.7) * 2 / 3);
  });
  const FrontEvidence e = seen(m);
  CHECK(e.blocked.before < 0.1 * e.reach.behind);
  CHECK(e.reach.behind == doctest::Approx(9).epsilon(0.1));
}
