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

TEST_CASE(
    "target_gutters__of_the_improved_form_grow_past_a_point_before_the_pipe_next_to_the_target") {
  TargetHouse house;
  house.add({9.7, -0.24, 1.1}, 0);  // it alone has no normal
  TargetCodeSettings settings;
  settings.input.form = CodeForm::kImproved;
  settings.input.codes = "5;9.7;-0.245;1.1;4\n";
  Task task;
  const Segmentation s = segment_by_target_codes(cloud_of(house.points, {}), settings, task);
  // What looks to the wall is not seen.
  CHECK(2 * house.confused(s, 4, 4) > house.of(4));
  CHECK(house.confused(s, 0, 4) <= 1);
  CHECK(house.confused(s, 1, 4) == 0);
}
