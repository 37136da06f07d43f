// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/target_objects.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/segment/codes/target_house.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("target_shapes__reach_as_far_as_their_points_but_for_strays") {
  const TargetHouse house;
  const Segmentation coded = house.coded(house.targets);
  const CodedNotes notes = read_coded_notes(coded.notes_json);
  Task task;
  const auto shapes = target_shapes(coded, notes, {}, 0.25, task);
  REQUIRE(shapes.size() == notes.objects.size());
  for (size_t i = 0; i < shapes.size(); ++i) {
    const std::string& geometry = notes.objects[i].geometry;
    CAPTURE(geometry);
    if (geometry == "gutter_target") {
      CHECK(shapes[i].rectangles.empty());
      CHECK(std::fabs(shapes[i].radius_m - 0.04) < 0.002);
      continue;
    }
    REQUIRE(shapes[i].rectangles.size() == (geometry == "window_target" ? 2u : 1u));
    const CodedWall& first = shapes[i].rectangles[0];
    CHECK(first.inward().v == doctest::Approx(1));  // its outside looks along -Y
    if (geometry == "wall_target") CHECK(std::fabs(first.length_m() - 10) < 0.05);
    if (geometry == "door_target") CHECK(std::fabs(first.length_m() - 1) < 0.025);
    if (geometry == "window_target") CHECK(std::fabs(first.a.v - 0.2) < 1e-3);
  }
  // A gap wider than the wall between them makes one of the two windows.
  CHECK(target_shapes(coded, notes, {}, 1.5, task)[2].rectangles.size() == 1);
}

TEST_CASE("target_shapes__a_door_ends_at_its_frame_whatever_is_strewn_beside_it") {
  TargetHouse house;
  for (int i = 0; i < 300; ++i)  // 6 % of the door's points, in its plane
    house.add({2.05 + 0.95 * (i % 20) / 20, 0.12, 0.05 + 0.127 * (i / 20)}, 2);
  const Segmentation coded = house.coded(house.targets);
  const CodedNotes notes = read_coded_notes(coded.notes_json);
  Task task;
  const auto shapes = target_shapes(coded, notes, {}, 0.25, task);
  for (size_t i = 0; i < shapes.size(); ++i)
    if (notes.objects[i].geometry == "door_target") {
      CHECK(notes.objects[i].points > 5200);
      CHECK(std::fabs(shapes[i].rectangles.at(0).length_m() - 1) < 0.025);
    }
}
