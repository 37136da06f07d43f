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

TEST_CASE("target_gutters__of_the_improved_form_that_grow_into_the_wall_keep_to_the_pipe") {
  // The visible half of a pipe whose right side runs on into the wall in a hollow: normals turn by small steps.
  constexpr double kRadius_m = 0.04, kHollow_m = 0.06, kPi = 3.14159265358979;
  TargetHouse house;
  house.points.clear();
  house.truth.clear();
  for (int k = 0; k < 300; ++k) {
    const double z = 0.01 * k;
    for (int i = 0; i <= 24; ++i) {
      const double angle = kPi + kPi * i / 24;
      house.add({5 + kRadius_m * std::cos(angle), kRadius_m * std::sin(angle), z}, 4);
    }
    for (int i = 1; i < 15; ++i) {
      const double angle = kPi - kPi / 2 * i / 15;
      house.add({5.1 + kHollow_m * std::cos(angle), kHollow_m * std::sin(angle), z}, 1);
    }
    for (int i = 0; i < 40; ++i) house.add({5.1 + 0.01 * i, kHollow_m, z}, 1);
  }
  TargetCodeSettings settings;
  settings.input.form = CodeForm::kImproved;
  settings.input.codes = "5;5;-0.04;1.1;4\n";
  Task task;
  const Segmentation s = segment_by_target_codes(cloud_of(house.points, {}), settings, task);
  CHECK(static_cast<double>(house.confused(s, 4, 4)) > 0.99 * static_cast<double>(house.of(4)));
  CHECK(static_cast<double>(house.confused(s, 1, 4)) < 0.1 * static_cast<double>(house.of(4)));
}
