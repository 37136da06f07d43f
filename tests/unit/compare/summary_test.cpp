// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "compare/comparison.h"
#include "compare/summary.h"

using namespace jalon;

TEST_CASE("summary__counts_each_status_and_takes_moments_of_the_compared_points_only") {
  const double nan = std::nan("");
  const std::vector<double> distances{1, nan, 3, nan, 5};
  const std::vector<uint8_t> statuses{0, 1, 0, 4, 0};
  Task task;
  const FieldTable row = summarise(distances, statuses, task);
  CHECK(row.require("points").number(0) == 5);
  CHECK(row.require("compared").number(0) == 3);
  CHECK(row.require("hidden").number(0) == 1);
  CHECK(row.require("nothing_near").number(0) == 1);
  CHECK(row.require("mean").number(0) == 3);
  CHECK(row.require("sigma").number(0) == 2);
  CHECK(row.require("rms").number(0) == doctest::Approx(std::sqrt(35.0 / 3)).epsilon(1e-15));
  CHECK(row.require("minimum").number(0) == 1);
  CHECK(row.require("maximum").number(0) == 5);
}

TEST_CASE("summary__of_nothing_compared_is_nan_with_its_counts") {
  const std::vector<double> distances{std::nan("")};
  const std::vector<uint8_t> statuses{static_cast<uint8_t>(CompareStatus::kOutOfField)};
  Task task;
  const FieldTable row = summarise(distances, statuses, task);
  CHECK(row.require("out_of_field").number(0) == 1);
  CHECK(std::isnan(row.require("mean").number(0)));
  CHECK(std::isnan(row.require("maximum").number(0)));
}
