// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/segment/codes/target_house.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("target_codes__every_class_is_found_about_its_targets") {
  const TargetHouse house;
  const Segmentation s = house.coded(house.targets);
  for (uint8_t c = 1; c <= 4; ++c) {
    CAPTURE(c);
    const double least = c == 1 ? 0.95 : 0.99;  // columns over the door are lower than a wall
    CHECK(static_cast<double>(house.confused(s, c, c)) > least * static_cast<double>(house.of(c)));
  }
  CHECK(static_cast<double>(house.confused(s, 0, 0)) > 0.99 * static_cast<double>(house.of(0)));
  CHECK(house.confused(s, 2, 3) + house.confused(s, 3, 2) == 0);
  const auto notes = nlohmann::json::parse(s.notes_json);
  CHECK(notes["method"] == "target_codes");
  CHECK(notes["objects"].size() == 4);
  CHECK(notes["objects"][2]["ids"] == nlohmann::json{"3", "4"});
  CHECK(notes["warnings"].empty());
}

TEST_CASE("target_codes__the_same_bits_for_any_threads_and_far_coordinates_lose_nothing") {
  const TargetHouse house;
  const Segmentation one = house.coded(house.targets, {}, 1),
                     four = house.coded(house.targets, {}, 4);
  const auto a = one.labels->values<uint32_t>(), b = four.labels->values<uint32_t>();
  CHECK(std::equal(a.begin(), a.end(), b.begin()));
  CHECK(one.notes_json == four.notes_json);
  const Segmentation far = house.coded("1;734500.5;642100;200.4;1\n2;734501.5;642100.12;200.5;2\n",
                                       {734500, 642100, 200});
  CHECK(house.confused(far, 2, 2) == house.of(2));
}

TEST_CASE("target_codes__odd_windows_and_unknown_codes_are_warnings") {
  const TargetHouse house;
  const Segmentation s = house.coded(house.targets + "7;5;0.2;1.5;3\n8;0;0;0;17\n");
  CHECK(warned(s, "windows 7").find("1 of 2") != std::string::npos);
  CHECK(warned(s, "point 8").find("unknown") != std::string::npos);
  CHECK(house.confused(s, 3, 3) == house.of(3));
}

TEST_CASE("target_codes__no_codes_make_no_segments") {
  CHECK(TargetHouse().coded("").segments.empty());
}
