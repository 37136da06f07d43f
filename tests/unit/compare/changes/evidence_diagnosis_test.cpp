// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/evidence_diagnosis.h"

#include <doctest/doctest.h>

#include "compare/changes/change_confidence.h"
#include "compare/distance/distance.h"
#include "unit/compare/detection/room_scan.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct DetectedPair {
  Comparison forward, reverse;
  DetectedPair(const RoomScan& was, const RoomScan& is, uint64_t seed) {
    const std::vector<Vec3> places{{-2.5, 1, 1.6}, {2, -1.5, 1.75}};
    const CloudPtr before = was.scan(places, 2 * seed), after = is.scan(places, 2 * seed + 1);
    Task task;
    DistanceSettings settings;
    settings.detection = true;
    settings.visibility = DistanceSettings::VisibleFrom::kStations;
    forward = compare_distance(before, after, settings, task);
    reverse = compare_distance(after, before, settings, task);
  }
  Diagnosis diagnosed() const {
    Task task;
    return diagnose(forward, reverse, {}, task);
  }
};

void check_one(const RoomScan& was, const RoomScan& is, ChangeClass expected) {
  for (uint64_t seed = 51; seed <= 53; ++seed) {
    const DetectedPair pair(was, is, seed);
    const Diagnosis found = pair.diagnosed();
    REQUIRE(found.changes.size() == 1);
    CHECK(found.changes[0].change_class == expected);
    CHECK(found.changes[0].confidence > 0.5);
  }
}

}  // namespace

TEST_CASE("classes_by_evidence__a_box_comes_and_goes") {
  RoomScan with;
  with.has_box = true;
  check_one({}, with, ChangeClass::kAppearance);
  check_one(with, {}, ChangeClass::kDisappearance);
}

TEST_CASE("classes_by_evidence__a_panel_of_a_wall_gives_way_either_way") {
  RoomScan before_wall, in_wall;
  before_wall.panel_m = 0.03;
  in_wall.panel_m = -0.03;
  check_one({}, before_wall, ChangeClass::kDeformationOverlap);
  check_one({}, in_wall, ChangeClass::kDeformationOverlap);
}

TEST_CASE("classes_by_evidence__a_room_scanned_twice_has_no_change") {
  for (uint64_t seed = 61; seed <= 63; ++seed)
    CHECK(DetectedPair({}, {}, seed).diagnosed().changes.empty());
}

TEST_CASE("classes_by_evidence__want_both_comparisons_with_detection") {
  RoomScan coarse;
  coarse.step_rad = 0.02;
  DetectedPair pair(coarse, coarse, 71);
  CHECK(has_evidence(pair.forward, pair.reverse));
  Task task;
  const Comparison plain = compare_distance(pair.forward.cloud, pair.reverse.cloud, {}, task);
  CHECK_FALSE(has_evidence(pair.forward, plain));
}
