// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "compare/landslide/zone_measures.h"
#include "slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("zone_measures__have_the_boxes_areas_volumes_and_boundaries") {
  const Comparison made = compared_slopes(slope_survey(false, 1), slope_survey(true, 2));
  const CellTable cells(made);
  const std::vector<ZoneMeasure> zones = zone_measures(cells);
  REQUIRE(zones.size() == 2);
  CHECK(zones[0].volume_m3 == doctest::Approx(-kScar_m3).epsilon(0.02).scale(0));
  CHECK(zones[1].volume_m3 == doctest::Approx(kToe_m3).epsilon(0.03).scale(0));
  CHECK(zones[0].area_m2 == doctest::Approx(48).epsilon(0.05));
  CHECK(zones[0].boundary_m >= 28);
  CHECK(zones[0].boundary_m <= 32);  // one cell beside it may belong by chance
  CHECK(zones[0].open_boundary_m == 0);
  CHECK(zones[0].volume_sigma_m3 > 0);
}
