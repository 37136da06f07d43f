// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_features.h"

#include <doctest/doctest.h>

#include "compare/changes/diagnosis.h"
#include "compare/distance/distance.h"
#include "unit/compare/detection/room_scan.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Change only_change(const RoomScan& was, const RoomScan& is, bool has_stations) {
  const std::vector<Vec3> places{{-2.5, 1, 1.6}, {2, -1.5, 1.75}};
  const CloudPtr before = was.scan(places, 81), after = is.scan(places, 82);
  Task task;
  DistanceSettings settings;
  settings.detection = true;
  settings.visibility = has_stations ? DistanceSettings::VisibleFrom::kStations
                                     : DistanceSettings::VisibleFrom::kAnywhere;
  const Comparison forward = compare_distance(before, after, settings, task),
                   reverse = compare_distance(after, before, settings, task);
  Diagnosis found = diagnose(forward, reverse, {}, task);
  found.changes.insert(found.changes.end(), found.untold.begin(), found.untold.end());
  REQUIRE_FALSE(found.changes.empty());
  return *std::max_element(found.changes.begin(), found.changes.end(),
                           [](const Change& a, const Change& b) {
                             return a.features[kFeaturePoints] < b.features[kFeaturePoints];
                           });
}

RoomScan coarse(double panel_m, bool has_box) {
  RoomScan out;
  out.step_rad = 0.016;
  out.panel_m = panel_m;
  out.has_box = has_box;
  return out;
}

}  // namespace

TEST_CASE("change_features__of_a_box_that_came_tell_that_its_place_was_seen_through") {
  const Change change = only_change(coarse(0, false), coarse(0, true), true);
  CHECK(family_of(change) == 0);
  const ChangeFeatures& f = change.features;
  CHECK(f[kFeatureOne] == 1);
  CHECK(f[kFeaturePoints] > 1);
  CHECK(f[kFeatureNoStations] == 0);
  CHECK(f[kFeatureThrough] > 0.8);
  CHECK(f[kFeatureNothingNear] == 0);
  CHECK(f[kFeatureBothSides] == 0);
  CHECK(f[kFeatureMovedSurface] < 0.2);
  CHECK(f[kFeatureWorst] == 0);
  CHECK(f[kFeatureThresholds] > 0);
  CHECK(f[kFeatureLevels] > 3);
  CHECK(f[kFeatureSlender] > 0.3);
}

TEST_CASE("change_features__without_stations_nothing_is_seen_through") {
  const Change change = only_change(coarse(0, false), coarse(0, true), false);
  CHECK(change.features[kFeatureNoStations] == 1);
  CHECK(change.features[kFeatureThrough] == 0);
  CHECK(change.features[kFeatureNothingNear] > 0.8);
}

TEST_CASE("change_features__of_a_panel_that_gave_way_have_both_sides") {
  const Change change = only_change(coarse(0, false), coarse(0.06, false), true);
  CHECK(family_of(change) == 2);
  CHECK(change.features[kFeatureBothSides] > 0.7);
  CHECK(change.features[kFeatureThrough] < 0.3);
  CHECK(change.features[kFeatureThresholds] ==
        doctest::Approx(std::log(0.06 / 0.05)).epsilon(0.3).scale(0));
}

TEST_CASE("change_features__of_one_change_have_nothing_like_it_beside") {
  const Change change = only_change(coarse(0, true), coarse(0, false), true);
  CHECK(change.change_class == ChangeClass::kDisappearance);
  CHECK(change.features[kFeatureLike] < 0.2);
  for (const double value : change.features) CHECK(std::isfinite(value));
}
