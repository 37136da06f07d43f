// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Settings of depth maps and of hidden points: what is refused, and what words and numbers mean.
#include "compare/visibility/settings.h"

#include <doctest/doctest.h>

#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("depth_settings__refuse_a_centre_that_is_no_point_and_take_the_words_of_the_table") {
  DepthSettings settings;
  CHECK_NOTHROW(settings.check());
  settings.second_centre_m = {0.5, -0.25, 0.125};
  CHECK(settings.second_centre() == Vec3{0.5, -0.25, 0.125});
  for (const std::vector<double>& wrong : {std::vector<double>{}, {1, 2}, {1, 2, 3, 4}}) {
    settings.second_centre_m = wrong;
    CHECK(status_of([&] { settings.check(); }) == Status::kInvalidArgument);
    CHECK_THROWS_WITH_AS(settings.check(), doctest::Contains("second_centre_m"), Error);
  }
  for (const auto& [word, rule] : {std::pair{"min", CellRule::kNearest},
                                   {"max", CellRule::kFarthest},
                                   {"mean", CellRule::kMean}})
    CHECK(settings_by<DepthSettings>(visibility_rows(), {{"depth_rule", word}}).rule == rule);
}

TEST_CASE("depth_settings__an_empty_cell_is_free_when_told_or_when_the_range_is_known") {
  for (const double range_m : {0.0, 80.0}) {
    const auto is_free = [&](const char* word) {
      auto settings = settings_by<DepthSettings>(visibility_rows(), {{"depth_empty", word}});
      settings.max_range_m = range_m;
      return settings.empty_is_free();
    };
    CHECK(is_free("free"));
    CHECK_FALSE(is_free("hides"));
    CHECK(is_free("auto") == (range_m > 0));
  }
}

TEST_CASE("hidden_settings__take_a_direction_of_any_length_but_none") {
  HiddenSettings settings;
  CHECK_NOTHROW(settings.check());
  settings.direction = {0, -3e-7, 4e-7};
  CHECK_NOTHROW(settings.check());
  CHECK(norm(settings.unit_direction() - Vec3{0, -0.6, 0.8}) < 1e-15);
  settings.direction = {0, 0, 0};
  CHECK(status_of([&] { settings.check(); }) == Status::kInvalidArgument);
  CHECK_THROWS_WITH_AS(settings.check(), doctest::Contains("hidden_direction"), Error);
  settings.direction = {0, 1};
  CHECK_THROWS_WITH_AS(settings.check(), doctest::Contains("three numbers"), Error);
}
