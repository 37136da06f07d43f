// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/segment/codes/target_house.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("target_gutters__grow_around_the_pipe_and_stop_at_the_wall") {
  const TargetHouse house;
  const Segmentation s = house.coded("5;9.7;-0.19;1.1;4\n");
  CHECK(static_cast<double>(house.confused(s, 4, 4)) > 0.99 * static_cast<double>(house.of(4)));
  CHECK(house.confused(s, 1, 4) == 0);
  CHECK(house.confused(s, 0, 4) == 0);
  REQUIRE(s.segments.size() == 1);
  CHECK(!s.segments[0].has_plane());
}

TEST_CASE("target_gutters__a_target_without_points_near_it_is_told") {
  const Segmentation s = TargetHouse().coded("1;9.7;-5;1.1;4\n");
  CHECK(s.segments.empty());
  CHECK(warned(s, "gutter 1").find("no point") != std::string::npos);
}
