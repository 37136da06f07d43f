// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/segment/codes/target_house.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("target_panes__a_door_ends_2_m_from_its_target") {
  // The window plane, taken for a door: only what is near the target.
  const TargetHouse house;
  const Segmentation s = house.coded("1;4.5;0.2;1.3;2\n");
  const auto labels = s.labels->values<uint32_t>();
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0) {
      const double distance = norm(house.points[i] - Vec3{4.5, 0.2, 1.3});
      CHECK(distance < 2);
    }
  CHECK(house.confused(s, 3, 2) == house.of(3) / 2);  // the second window begins 2.5 m from it
}

TEST_CASE("target_panes__windows_of_a_facade_reach_1_m_beyond_their_targets") {
  const TargetHouse house;
  const Segmentation s = house.coded("1;4.5;0.2;1.3;3\n2;5.5;0.2;1.3;3\n");
  CHECK(house.confused(s, 3, 3) == house.of(3) / 2);  // the second window begins at x = 7
}

TEST_CASE("target_panes__two_targets_of_different_planes_are_no_facade") {
  const TargetHouse house;
  const Segmentation s = house.coded("1;4.5;0.2;1.3;3\n2;2.025;-2.025;0;3\n");
  CHECK(warned(s, "windows 1").find("no common plane") != std::string::npos);
  CHECK(s.segments.empty());
}

TEST_CASE("target_panes__improved_reveals_are_no_windows") {
  TargetHouse house;
  for (double y = 0.01; y < 0.2; y += 0.02)
    for (const double left : {4.0, 7.0}) {
      for (double z = 1.01; z < 2; z += 0.02)
        house.add({left, y, z}, 1), house.add({left + 2, y, z}, 1);
      for (double x = left + 0.01; x < left + 2; x += 0.02)
        house.add({x, y, 1}, 1), house.add({x, y, 2}, 1);
    }
  TargetCodeSettings settings;
  settings.input.codes = house.targets;
  Task task;
  const CloudPtr cloud = cloud_of(house.points);
  const Segmentation source = segment_by_target_codes(cloud, settings, task);
  settings.input.form = CodeForm::kImproved;
  const Segmentation improved = segment_by_target_codes(cloud, settings, task);
  CHECK(house.confused(source, 1, 3) > 800);  // two rows of the reveals of both windows
  CHECK(house.confused(improved, 1, 3) == 0);
  CHECK(house.confused(improved, 3, 3) == house.of(3));
  CHECK(house.confused(improved, 2, 2) == house.of(2));
}

TEST_CASE("target_panes__improved_a_leaf_that_stands_open_is_a_window") {
  // Between the two with targets a narrow one, turned inward by 20 degrees about either end.
  for (const bool is_left : {true, false}) {
    TargetHouse house;
    const double angle = std::acos(-1.0) / 9;
    size_t first = house.points.size();
    for (double u = 0.01; u < 0.6; u += 0.02)
      for (double z = 1.01; z < 2; z += 0.02)
        house.add({is_left ? 6.2 + std::cos(angle) * u : 6.8 - std::cos(angle) * u,
                   0.2 + std::sin(angle) * u, z},
                  3);
    TargetCodeSettings settings;
    settings.input.codes = house.targets;
    settings.input.form = CodeForm::kImproved;
    Task task;
    const Segmentation s = segment_by_target_codes(cloud_of(house.points), settings, task);
    const auto classes = s.cloud->fields.require("classification").values<uint8_t>();
    size_t right = 0;
    const size_t all = house.points.size() - first;
    for (; first < house.points.size(); ++first) right += classes[first] == 3;
    CHECK(right > all * 98 / 100);
  }
}

TEST_CASE("target_panes__a_leaf_of_which_the_wall_took_most_is_told") {
  TargetHouse house(0.02);
  size_t count = 0;
  for (size_t i = 0; i < house.truth.size(); ++i)
    if (house.truth[i] == 2 && count++ % 3 == 0) house.points[i].y = 0.06;
  const Segmentation s = house.coded("1;0.5;0;0.4;1\n2;1.5;0.06;0.5;2\n");
  CHECK(house.confused(s, 2, 1) > house.confused(s, 2, 2));
  CHECK(house.confused(s, 2, 2) > 0);
  CHECK(warned(s, "door 2").find("flush with its wall") != std::string::npos);
  const TargetHouse behind;
  CHECK(warned(behind.coded(behind.targets), "door 2").empty());
}

TEST_CASE("target_panes__improved_a_flush_leaf_is_found_among_the_waves_of_its_wall") {
  // The same wall and leaf as everywhere, the wall in waves about it.
  TargetHouse house(0.02);
  for (size_t i = 0; i < house.points.size(); ++i)
    if (house.truth[i] == 1 && house.points[i].x > 0.6)  // even at its target
      house.points[i].y = 0.025 * std::sin(31.4159 * house.points[i].x);
  TargetCodeSettings settings;
  settings.input.codes = "1;0.5;0;0.4;1\n2;1.5;0.02;0.5;2\n";
  Task task;
  const CloudPtr cloud = cloud_of(house.points);
  const Segmentation source = segment_by_target_codes(cloud, settings, task);
  CHECK(house.confused(source, 2, 2) < house.of(2) * 6 / 10);
  settings.input.form = CodeForm::kImproved;
  const Segmentation improved = segment_by_target_codes(cloud, settings, task);
  CHECK(house.confused(improved, 2, 2) > house.of(2) * 95 / 100);
  CHECK(house.confused(improved, 1, 2) < house.of(2) / 10);  // crests beside it
  CHECK(warned(improved, "door 2").empty());
}

TEST_CASE("target_panes__a_facade_that_lacks_a_target_is_named_and_those_behind_it_keep_theirs") {
  // Before the pair of the front one target of another facade, whose other is forgotten.
  TargetHouse house;
  for (int i = 0; i < 9; ++i)
    for (int k = 0; k < 9; ++k) house.add({-3, 5 + 0.01 * i, 1.26 + 0.01 * k}, 0);
  const Segmentation s = house.coded("1;-3;5.04;1.3;3\n2;4.5;0.2;1.3;3\n3;8.5;0.2;1.3;3\n");
  CHECK(warned(s, "windows 1").find("1 of 2 points") != std::string::npos);
  CHECK(warned(s, "windows 1").find("those behind it keep their own") != std::string::npos);
  CHECK(house.confused(s, 3, 3) > house.of(3) / 2);
}
