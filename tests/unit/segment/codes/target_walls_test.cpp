// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/segment/codes/target_house.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("target_walls__end_below_the_gap_and_leave_low_columns") {
  const TargetHouse house;
  const Segmentation s = house.coded("1;0.5;0;0.4;1\n");
  CHECK(house.confused(s, 0, 1) == 0);  // neither the strip of roof nor the ground at the foot
  CHECK(house.confused(s, 1, 1) > house.of(1) * 9 / 10);  // window columns still reach 2 m
}

TEST_CASE("target_walls__take_a_door_that_is_flush_which_is_told") {
  const TargetHouse flush(0.02);
  const Segmentation s = flush.coded(flush.targets);
  CHECK(flush.confused(s, 2, 1) == flush.of(2));
  CHECK(warned(s, "door 2").find("flush") != std::string::npos);
}

TEST_CASE("target_walls__a_target_off_the_cloud_is_told") {
  const Segmentation s = TargetHouse().coded("1;0.5;-2.02;1.7;1\n");
  CHECK(warned(s, "wall 1").find("fewer than three") != std::string::npos);
  CHECK(s.segments.empty());
}
