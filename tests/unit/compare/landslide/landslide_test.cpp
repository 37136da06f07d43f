// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstring>

#include "base/error.h"
#include "compare/landslide/ground_grid.h"
#include "slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("landslide__tells_what_went_and_came_within_three_sigma") {
  const Comparison made = compared_slopes(slope_survey(false, 1), slope_survey(true, 2));
  MESSAGE("FIGURE landslide of boxes: depletion ", summed(made, "depletion"), " of ", kScar_m3,
          " m3, sigma ", summed(made, "depletion_sigma"));
  CHECK(std::abs(summed(made, "depletion") - kScar_m3) < 3 * summed(made, "depletion_sigma"));
  CHECK(std::abs(summed(made, "accumulation") - kToe_m3) < 3 * summed(made, "accumulation_sigma"));
  CHECK(summed(made, "depletion_sigma") < 0.05 * kScar_m3);
  CHECK(summed(made, "net") ==
        doctest::Approx(summed(made, "accumulation") - summed(made, "depletion")));
  CHECK(summed(made, "depletion_area") == doctest::Approx(48).epsilon(0.05));
  CHECK(summed(made, "unmeasured_share") < 0.01);
}

TEST_CASE("landslide__of_nothing_moved_has_no_zone") {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const Comparison made =
        compared_slopes(slope_survey(false, 10 + seed), slope_survey(false, 20 + seed));
    CHECK(summed(made, "significant") == 0);
    CHECK(summed(made, "depletion") == 0);
    CHECK(summed(made, "accumulation_sigma") == 0);
  }
}

TEST_CASE("landslide__fills_in_nothing_where_an_epoch_has_no_points") {
  // A strip through the middle of the scar.
  const auto gap = [](double x, double y) { return x > 18 && x < 22 && y > 15 && y < 27; };
  const Comparison made =
      compared_slopes(slope_survey(false, 1), slope_survey(true, 2, 60000, gap));
  CHECK(summed(made, "depletion") == doctest::Approx(kScar_m3 / 2).epsilon(0.1).scale(0));
  CHECK(summed(made, "unmeasured_compared") == doctest::Approx(4 * 12).epsilon(0.05).scale(0));
  CHECK(summed(made, "unmeasured_reference") < 1);
  CHECK(summed(made, "unmeasured_beside_zones") == doctest::Approx(4 * 12).epsilon(0.05).scale(0));
  CHECK(summed(made, "open_boundary") == doctest::Approx(12).epsilon(0.2));  // both sides, 6 m each
}

// As where a point stands at the origin of its national grid.
TEST_CASE("landslide__of_a_slope_and_a_far_point_is_that_of_the_slope") {
  const auto with_stray = [](const CloudPtr& cloud) {
    std::vector<Vec3> points = {{-200000.5, 15, 100}};
    for (size_t i = 0; i < cloud->size(); ++i) points.push_back(cloud->point(i));
    return cloud_of_points(points);
  };
  // A hole, whose cells are told of, and a corner, whose cells are not.
  const auto gap = [](double x, double y) {
    return (x > 10 && x < 14 && y > 10 && y < 14) || (x > 30 && y > 20);
  };
  const CloudPtr before = slope_survey(false, 1, 20000, gap),
                 after = slope_survey(true, 2, 20000, gap), far_before = with_stray(before),
                 far_after = with_stray(after);
  LandslideSettings settings;
  settings.cell_m = 1;
  Task task;
  CHECK(ground_grid(*far_before, *far_after, settings, task).cells() < 5 * KeptBlocks::kBlock * 30);
  const Comparison alone = compared_slopes(before, after),
                   both = compared_slopes(far_before, far_after);
  for (const char* name : {"depletion", "accumulation", "net_sigma", "systematic", "boundary"})
    CHECK(summed(both, name) == doctest::Approx(summed(alone, name)).epsilon(1e-3));
  REQUIRE(both.cloud->size() == alone.cloud->size() + 1);
  const Column &column = both.points.require("column"), &near = alone.points.require("column");
  size_t same = 0, other = 0;  // rows, by their places
  for (size_t i = 0; i < alone.cloud->size(); ++i, ++other) {
    if (column.number(other) < 1000) ++other;
    CHECK(column.number(other) == near.number(i) + 200001);
    same += norm(both.cloud->point(other) - alone.cloud->point(i)) < 1e-6 ? 1 : 0;
  }
  CHECK(same == alone.cloud->size());
}

TEST_CASE("landslide__refuses_empty_clouds_and_short_lists") {
  const CloudPtr some = slope_survey(false, 1, 100), none = std::make_shared<const Cloud>();
  CHECK_THROWS_AS(compared_slopes(none, some), Error);
  CHECK_THROWS_AS(compared_slopes(some, none), Error);
  LandslideSettings settings;
  settings.direction = {1, 0};
  CHECK_THROWS_AS(compared_slopes(some, some, settings), Error);
  settings.direction = {0, 0, 0};
  CHECK_THROWS_AS(compared_slopes(some, some, settings), Error);
}

TEST_CASE("landslide__same_bits_for_any_threads") {
  const CloudPtr before = slope_survey(false, 1, 20000), after = slope_survey(true, 2, 20000);
  const auto run = [&](unsigned threads) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    return compare_landslide(before, after, {}, task);
  };
  const Comparison one = run(1), four = run(4);
  for (const ColumnPtr& column : one.points) {
    const Column& again = four.points.require(column->info().name);
    REQUIRE(again.bytes() == column->bytes());
    CHECK(std::memcmp(again.raw(), column->raw(), column->bytes()) == 0);
  }
}
