// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/clearance_chart.h"

#include <doctest/doctest.h>

#include "unit/report/charts/swept_gauge.h"

using namespace jalon;

TEST_CASE("clearance_chart__metres_of_way_margin_and_the_numbers_of_tight_places") {
  const SweepTables tables = swept::tables();
  const GaugePath path(swept::way());
  const std::string svg =
      clearance_chart(tables.intervals, path, tight_places(tables.places, path, 1, 40), 0.1);
  CHECK(svg.find("Way of the gauge (m)") != std::string::npos);
  CHECK(svg.find("stroke-dasharray") != std::string::npos);
  CHECK(svg.find(">2</text>") != std::string::npos);
  CHECK(svg.find(clearance_colour(-0.1, 0.1)) != std::string::npos);
  CHECK(svg.find(clearance_colour(0.05, 0.1)) != std::string::npos);
}

TEST_CASE("clearance_chart__a_gauge_that_stands_has_no_way") {
  CHECK(clearance_chart(swept::tables().intervals, GaugePath({Transform{}}), {}, 0.1).empty());
}
