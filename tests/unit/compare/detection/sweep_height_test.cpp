// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/sweep_height.h"

#include <doctest/doctest.h>

#include "unit/compare/detection/room_scan.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("sweep_height__is_where_the_steps_of_a_sweep_are_even") {
  Task task;
  const CloudPtr cloud = RoomScan{}.scan({{1, 0.5, 1.42}}, 5);
  const auto height = sweep_height(*cloud, 0, cloud->size(), {1, 0.5, 0}, task);
  REQUIRE(height.has_value());
  CHECK(*height == doctest::Approx(1.42).epsilon(0.01));
}

TEST_CASE("sweep_height__is_none_from_too_few_points") {
  Task task;
  const CloudPtr cloud = RoomScan{}.scan({{1, 0.5, 1.42}}, 5);
  CHECK_FALSE(sweep_height(*cloud, 0, 40, {1, 0.5, 0}, task).has_value());
}
