// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/survey_text.h"

#include <doctest/doctest.h>

#include <numbers>

#include "base/error.h"

using namespace jalon;

namespace {

std::string refusal_of_survey(const char* points, const char* observations) {
  try {
    read_survey(points, observations, AngleUnit::kGon);
  } catch (const Error& error) {
    CHECK(error.status() == Status::kFormat);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("survey_text__columns_are_named_in_any_order_and_cells_may_be_missing") {
  const Survey s = read_survey("# nails\nid;y;x;z;sx;sy;sz\nA;200;100;5;0;0;0.01\nB;;;;\n",
                               "to from zenith direction distance target_height code\nB A 100 50 "
                               "10.5 1.4 921\n\nC A - 75 - - -\n",
                               AngleUnit::kGon);
  REQUIRE(s.points.size() == 3);
  CHECK(s.points[0].position == Vec3{100, 200, 5});
  CHECK(s.points[0].sigma_m == Vec3{0, 0, 0.01});
  CHECK_FALSE(s.points[1].is_placed());
  CHECK(s.points[1].code == "921");
  CHECK(s.points[2].id == "C");
  REQUIRE(s.sightings.size() == 2);
  CHECK(s.sightings[0].direction_rad == doctest::Approx(std::numbers::pi / 4));
  CHECK(s.sightings[0].zenith_rad == doctest::Approx(std::numbers::pi / 2));
  CHECK(s.sightings[0].is_polar());
  CHECK_FALSE(s.sightings[1].is_polar());
  CHECK(s.sightings[1].line == 4);
}

TEST_CASE("survey_text__a_setup_ends_where_station_or_name_changes") {
  const Survey s =
      read_survey("", "from,to,setup,direction\nA,B,1,0\nA,C,1,1\nA,B,2,0\nB,A,2,0\nA,B,,0\n",
                  AngleUnit::kDegree);
  CHECK(s.setups.size() == 4);
  CHECK(s.sightings[1].setup == 0);
  CHECK(s.sightings[4].setup == 3);
}

TEST_CASE("survey_text__the_second_face_tells_the_same_angles") {
  const Survey s = read_survey("", "from\tto\tdirection\tzenith\nA\tB\t30\t95\nA\tB\t230\t305\n",
                               AngleUnit::kGon);
  CHECK(s.sightings[1].direction_rad == doctest::Approx(s.sightings[0].direction_rad));
  CHECK(s.sightings[1].zenith_rad == doctest::Approx(s.sightings[0].zenith_rad));
}

TEST_CASE("survey_text__what_is_wrong_is_told_with_its_list_line_and_cell") {
  CHECK(refusal_of_survey("id;x;x\n", "from to\n").find("points, line 1") == 0);
  CHECK(refusal_of_survey("", "from to way\nA B 3\n").find("\"way\"") != std::string::npos);
  CHECK(refusal_of_survey("", "from to distance\nA B 3,5\n").find("line 2") != std::string::npos);
  CHECK(refusal_of_survey("", "from to distance\nA B -3\n").find("no distance") !=
        std::string::npos);
  CHECK(refusal_of_survey("", "from to zenith\nA B 400\n").find("zenith") != std::string::npos);
  CHECK(refusal_of_survey("", "from to distance\nA A 3\n").find("itself") != std::string::npos);
  CHECK(refusal_of_survey("", "from to distance\nA\n").find("\"to\"") != std::string::npos);
  CHECK(refusal_of_survey("", "from to distance\nA B 1 2\n").find("more cells") !=
        std::string::npos);
  CHECK(refusal_of_survey("id x\nA 1\nA 2\n", "from to\n").find("already") != std::string::npos);
  CHECK(refusal_of_survey("id sx\nA 0\n", "from to\n").find("without its coordinate") !=
        std::string::npos);
  CHECK(refusal_of_survey("id sx x\nA -1 0\n", "from to\n").find("too small") != std::string::npos);
  CHECK(refusal_of_survey("", "from to sigma_distance\nA B 0\n").find("of 0") != std::string::npos);
}
