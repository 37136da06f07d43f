// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/sights.h"

#include <doctest/doctest.h>

#include "unit/compare/detection/room_scan.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("sights__tell_a_surface_what_lies_before_it_and_what_behind") {
  Task task;
  const CloudPtr cloud = RoomScan{}.scan({{-2, 0, 1.5}}, 6);
  const Sights sights(*cloud, task);
  const Vec3 to_wall{1, 0, 0}, up{0, 0, 1};
  CHECK(sights.look({5, 0.3, 1.2}, to_wall, 0.01) == PlaceSight::kSurface);
  CHECK(sights.look({4.9, 0.3, 1.2}, to_wall, 0.01) == PlaceSight::kThrough);
  CHECK(sights.look({5.1, 0.3, 1.2}, to_wall, 0.01) == PlaceSight::kHidden);
  // Slanted surfaces run away within the cells about a direction: the floor five metres off.
  CHECK(sights.look({3.5, 0.3, 0}, up, 0.01) == PlaceSight::kSurface);
  CHECK(sights.look({3.5, 0.3, 0.05}, up, 0.01) == PlaceSight::kThrough);
  // Straight up and down nothing was measured.
  CHECK(sights.look({-2, 0, 3}, up, 0.01) == PlaceSight::kUnknown);
}

TEST_CASE(
    "sights__a_surface_that_one_station_saw_counts_before_a_place_that_another_looked_through") {
  Task task;
  RoomScan room;
  room.has_box = true;
  const CloudPtr cloud = room.scan({{-2, 0, 1.5}, {4.6, -2, 1.5}}, 7);
  const Sights sights(*cloud, task);
  CHECK(sights.look({2.6, 1, 0.5}, {1, 0, 0}, 0.01) == PlaceSight::kSurface);
  CHECK(sights.look({3, 1, 0.5}, {1, 0, 0}, 0.01) == PlaceSight::kHidden);
}
