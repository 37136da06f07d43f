// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/e57/normals.h"

#include <doctest/doctest.h>

#include "unit/formats/fixtures.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("e57_normals__three_columns_become_one_field_turned_by_the_pose") {
  Cloud cloud = random_points(2, 1);
  Transform quarter;  // x to y
  quarter.m = {0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7};
  cloud.stations = {{"a", true, quarter, 0, 1}};
  const std::vector<float> x = {1, 1}, none = {0, 0};
  cloud.fields.set(make_column<float>({"normalX"}, std::span(x)));
  cloud.fields.set(make_column<float>({"normalY"}, std::span(none)));
  join_normals(cloud);
  CHECK(cloud.fields.find("normal") == nullptr);  // the third is missing
  cloud.fields.set(make_column<float>({"normalZ"}, std::span(none)));
  join_normals(cloud);
  CHECK(cloud.fields.size() == 1);
  const auto normals = cloud.fields.require("normal").values<float>();
  CHECK(normals[0] == 0);
  CHECK(normals[1] == 1);
  CHECK(normals[3] == 1);  // of no station
  CHECK(normals[4] == 0);
}
