// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_extents.h"

#include <doctest/doctest.h>

using namespace jalon;

TEST_CASE("strip_extents__of_a_wall_that_looks_north__reach_along_it_and_up") {
  StripScene scene;
  scene.strips = {{0, 0, {0, 1}, 5}, {0, 0, {0, 1}, 7}};  // the second has no faces
  const Vec3 p{2, 5, 1}, way{1.5, 0, 0}, up{0, 0, 9};
  scene.corners = {p, p + way, p + way + up};
  scene.face_of = {0}, scene.strip_of_face = {0}, scene.block_of_face = {0};
  const std::vector<StripExtent> made = strip_extents(scene);
  REQUIRE(made.size() == 2);
  CHECK(made[0].from == -3.5);  // places count west
  CHECK(made[0].to == -2);
  CHECK(made[0].contains(-3, 9.5));
  CHECK(!made[0].contains(-3, 10.5));
  CHECK(made[1].is_empty());
  const std::vector<Vec3> middles = strip_middles(scene, made);
  CHECK(middles[0].x == 2.75);
  CHECK(middles[0].y == 5);
}
