// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/survey_space.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/segment/codes/coded.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// A house of 10 x 8 x 3 m that looks along -Y, with one door, one window over its head and a gutter at a corner.
const char* const kHouse =
    "1;0;0;3;300.2\n2;10;0;3;300.4\n3;10;8;3;300.4\n4;0;8;3;300.4\n5;0;0;0;300.4\n"
    "6;1;0.1;0;350\n7;2;0.1;2;350\n8;1;0.12;1.9;360\n9;2;0.12;2.5;360\n"
    "10;-0.05;4;0;408\n11;-0.09;4;0;409\n12;-0.05;4;2.8;410\n";

std::string at(const char* list, const Vec3& p) {
  const CodeTable table = code_table_from_json(kSurveyCodeTable);
  const CodedObjects all = surveyed(list);
  const SurveyCodeSettings settings;
  const uint32_t object = SurveySpace(table, all, settings).object_at(p - all.origin);
  return object == 0 ? "" : all.objects[object - 1].name;
}

}  // namespace

TEST_CASE("survey_space__a_shell_is_4_cm_outside_and_24_cm_inside_the_outline") {
  CHECK(at(kHouse, {5, -0.039, 1}) == "building 1");
  CHECK(at(kHouse, {5, -0.041, 1}) == "");
  CHECK(at(kHouse, {5, 0.239, 1}) == "building 1");
  CHECK(at(kHouse, {5, 0.241, 1}) == "");
  CHECK(at(kHouse, {9.77, 4, 1}) == "building 1");
  CHECK(at(kHouse, {5, 4, 1}) == "");
  CHECK(at(kHouse, {5, 0, -0.019}) == "building 1");
  CHECK(at(kHouse, {5, 0, -0.021}) == "");
  CHECK(at(kHouse, {5, 0, 3.019}) == "building 1");
  CHECK(at(kHouse, {5, 0, 3.021}) == "");
  CHECK(at(kHouse, {500, 0, 1}) == "");
}

TEST_CASE("survey_space__openings_lie_about_their_plane_within_the_building") {
  CHECK(at(kHouse, {1.5, 0.1, 1}) == "door 6");
  CHECK(at(kHouse, {1.5, 0.119, 1}) == "door 6");
  CHECK(at(kHouse, {1.5, 0.081, 1}) == "door 6");
  CHECK(at(kHouse, {1.5, 0.121, 1}) == "building 1");
  CHECK(at(kHouse, {1.5, 0.12, 2.51}) == "window 8");
  CHECK(at(kHouse, {1.5, 0.12, 2.53}) == "building 1");
  CHECK(at(kHouse, {1.5, 0.12, 1.95}) == "window 8");  // both hold it: the later one of the table
}

TEST_CASE("survey_space__distance_from_an_oblique_opening_has_no_sign") {
  // On the line y = x the bounding box is large: only the distance keeps points out, on both sides and either order.
  const char* lists[] = {"1;1;1;0;360\n2;2;2;2;360\n", "1;2;2;2;360\n2;1;1;0;360\n"};
  const double q = std::sqrt(0.5);
  for (const char* list : lists)
    for (const double side : {1.0, -1.0}) {
      CHECK(at(list, {1.5 - side * 0.029 * q, 1.5 + side * 0.029 * q, 1}) == "window 1");
      CHECK(at(list, {1.5 - side * 0.031 * q, 1.5 + side * 0.031 * q, 1}) == "");
    }
}

TEST_CASE("survey_space__pipes_come_before_walls_and_end_at_foot_and_top") {
  CHECK(at(kHouse, {-0.05, 4, 1}) == "gutter 10");
  CHECK(at(kHouse, {0.005, 4, 1}) == "gutter 10");  // 4 cm and a margin of 2
  CHECK(at(kHouse, {0.011, 4, 1}) == "building 1");
  CHECK(at(kHouse, {-0.05, 4, 2.801}) == "");
  CHECK(at(kHouse, {-0.05, 4, -0.001}) == "");
}

TEST_CASE("survey_space__a_bent_pipe_follows_its_axis") {
  const char* list = "1;0;0;0;415.2\n2;0.05;0;1;415.8\n3;0;0;2;415.4\n4;1;0;2;415.4\n";
  CHECK(at(list, {0.06, 0, 1}) == "gutter 1");
  CHECK(at(list, {0.5, 0.06, 2}) == "gutter 1");
  CHECK(at(list, {-0.04, 0, 2.04}) == "gutter 1");
  CHECK(at(list, {0.5, 0, 1.9}) == "");
  CHECK(at(list, {1.01, 0, 2}) == "");
}

TEST_CASE("survey_space__an_outline_holds_what_its_polygon_holds") {
  const char* list = "1;0;0;0;365.2\n2;2;0;0;365.4\n3;1;0;2;365.0\n";
  CHECK(at(list, {1, 0.02, 1}) == "window 1");
  CHECK(at(list, {1, 0.04, 1}) == "");
  CHECK(at(list, {0.2, 0, 1}) == "");
  CHECK(at(list, {1, 0, -0.015}) == "window 1");
}

TEST_CASE("survey_space__without_objects_nothing_is_found") { CHECK(at("", {0, 0, 0}) == ""); }
