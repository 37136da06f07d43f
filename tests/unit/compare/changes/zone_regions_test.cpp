// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "compare/changes/regions.h"
#include "unit/compare/landslide/slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("zone_regions__are_the_zones_with_their_sigma") {
  const Comparison made = compared_slopes(slope_survey(false, 1), slope_survey(true, 2));
  Task task;
  const ChangeRegions found = change_regions(made, {}, task);
  REQUIRE(found.regions.size() == 2);
  CHECK(found.has_zones);
  CHECK(found.regions[0].mean_m < 0);
  CHECK(found.regions[0].volume_m3 == doctest::Approx(kScar_m3).epsilon(0.02).scale(0));
  CHECK(found.regions[1].mean_m > 0);
  const FieldTable table = regions_table(found);
  CHECK(table.require("volume_sigma").number(0) > 0);
  CHECK(table.require("open_boundary").number(0) == 0);
  const auto zones = made.points.require("zone").values<uint32_t>();
  for (size_t i = 0; i < zones.size(); ++i) CHECK(found.labels[i] == zones[i]);
}

TEST_CASE("zone_regions__are_not_asked_for_by_a_threshold") {
  const Comparison made = compared_slopes(slope_survey(false, 1), slope_survey(true, 2));
  Task task;
  RegionSettings settings;
  settings.criterion = RegionSettings::Criterion::kThreshold;
  settings.threshold_m = 0.4;
  CHECK_FALSE(change_regions(made, settings, task).has_zones);
}
