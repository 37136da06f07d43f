// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Method "region_growing" on real facades with hand labels: 1 wall, 2 door, 3 window.
#include <doctest/doctest.h>

#include <cmath>

#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr int kWall = 1, kDoor = 2, kWindow = 3;
constexpr double kBehind_m =
    0.05;  // doors and windows set back at least so far share no segment with the wall
constexpr double kNearWall_m = 0.03;
// Below the shop signs the walls go on 0.8 to 1.2 m farther down, in both streets.
constexpr const char* kJoinPieces = "{\"merge_gap_m\": 1.2}";

void check_street(const char* name) {
  const Scene scene = street(name);
  if (scene.points.empty()) {
    MESSAGE("skipped: the real scans are not on this machine");
    return;
  }
  const Segmentation s = grow(cloud_of(scene.points), kJoinPieces);
  REQUIRE(!s.segments.empty());
  const PlaneFit& wall = s.segments[0].fit;
  const auto labels = s.labels->values<uint32_t>();
  size_t near = 0, found = 0, behind = 0, shared = 0;
  for (size_t i = 0; i < labels.size(); ++i) {
    const double distance = wall.plane.distance(scene.points[i]);
    if (scene.faces[i] == kWall && std::fabs(distance) <= kNearWall_m) {
      ++near;
      found += labels[i] == 1;
    }
    if ((scene.faces[i] == kDoor || scene.faces[i] == kWindow) && distance < -kBehind_m) {
      ++behind;
      shared += labels[i] == 1;
    }
  }
  MESSAGE("FIGURE " << std::string(name) << ": " << s.segments.size()
                    << " segments, sigma of the wall " << wall.sigma << " m, " << found << " of "
                    << near << " wall points within 3 cm, " << shared << " of " << behind
                    << " door and window points 5 cm behind share its segment");
  CHECK(static_cast<double>(found) >= 0.98 * static_cast<double>(near));
  CHECK(behind > 100);
  CHECK(shared == 0);
  CHECK(std::fabs(wall.plane.normal.z) < 0.05);
}

}  // namespace

TEST_CASE("growing finds the wall of street 1 and keeps doors and windows out of it") {
  check_street("street_1.txt");
}
TEST_CASE("growing finds the wall of street 3 and keeps doors and windows out of it") {
  check_street("street_3.txt");
}
