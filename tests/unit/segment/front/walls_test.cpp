// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/walls.h"

#include <doctest/doctest.h>

#include "unit/segment/front/made_walls.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("wall_groups__pieces_of_one_plane_are_members_and_small_near_ones_attendants") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 10, 4);                 // 0: the main wall
  m.upright({0, 0.02, 4.5}, 1, 10, 3);            // 1: above a band, the same plane
  m.upright({2, 0.2, 1}, 1, 1.5, 1.5);            // 2: a pane behind it
  m.upright({0, 16, 0}, 1, 10, 3.5);              // 3: another wall
  m.upright({30, 0, 1}, 1, 1, 1);                 // 4: a small thing far beside
  m.level({0, -5, 0}, 10, 5);                     // 5: the ground
  m.add({10, 0, 0}, {0, 1, 0}, {0, 0, 1}, 5, 3);  // 6: round the corner
  const std::vector<WallGroup> groups = wall_groups(m.segments);
  REQUIRE(groups.size() == 3);
  CHECK(groups[0].members == std::vector<size_t>{0, 1});
  CHECK(groups[0].attendants == std::vector<size_t>{2});
  CHECK(groups[1].members == std::vector<size_t>{3});
  CHECK(groups[2].members == std::vector<size_t>{6});
}

TEST_CASE("wall_groups__both_faces_of_a_free_wall_are_judged_each_by_itself") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 8, 3);
  m.upright({8, 0.3, 0}, -1, 8, 2.9);
  CHECK(wall_groups(m.segments).size() == 2);
  CHECK(wall_groups({}).empty());
}
