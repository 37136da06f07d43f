// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/code_list.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "segment/codes_settings.h"
#include "unit/segment/codes/annex.h"

using namespace jalon;
using namespace jalon::test;

namespace {

CodeList read(const std::string& text) {
  return read_code_list(text, code_table_from_json(kSurveyCodeTable));
}

}  // namespace

TEST_CASE("code_list__the_annex_has_437_points_and_12_stations") {
  const CodeList list = read(code_list_of(kAnnexSurvey));
  CHECK(list.warnings.empty());
  CHECK(list.points.size() == 449);
  int stations = 0;
  for (const CodedPoint& p : list.points) stations += p.sequence == 921;
  CHECK(stations == 12);
  CHECK(read_code_list(code_list_of(kAnnexTargets), code_table_from_json(kTargetCodeTable))
            .points.size() == 54);
}

TEST_CASE("code_list__splits_sequence_and_modifier_and_several_codes") {
  const CodeList list = read(
      "ID;X;Y;Z;code\n# corner that is also a door\n\n 7;1.5;-2;3e1;300.2+350\r\nA8;0;0;0;361.0");
  REQUIRE(list.points.size() == 3);
  CHECK(list.points[0].id == "7");
  CHECK(list.points[0].position == Vec3{1.5, -2, 30});
  CHECK(list.points[0].line == 4);
  CHECK(list.points[0].sequence == 300);
  CHECK(list.points[0].modifier == 2);
  CHECK(list.points[1].id == "7");
  CHECK(list.points[1].sequence == 350);
  CHECK(list.points[1].modifier == kNoModifier);
  CHECK(list.points[2].id == "A8");
  CHECK(list.points[2].modifier == 0);
}

TEST_CASE("code_list__takes_lines_as_programs_end_them_and_empty_columns_behind_the_code") {
  for (const char* text : {"1;2;3;4;360\r5;6;7;8;361", "1;2;3;4;360\r\n5;6;7;8;361\r\n",
                           "1;2;3;4;360;\n5;6;7;8;361;;;\n"}) {
    CAPTURE(text);
    const CodeList list = read(text);
    REQUIRE(list.points.size() == 2);
    CHECK(list.points[1].line == 2);
    CHECK(list.points[1].sequence == 361);
  }
  CHECK_THROWS_WITH_AS(read("1;2;3;4;360;note"), doctest::Contains("6 columns"), Error);
}

TEST_CASE("code_list__lengths_of_another_unit_become_metres") {
  const CodeTable table = code_table_from_json(kSurveyCodeTable);
  CHECK(read_code_list("1;10;20;30;360", table, 0.3048).points.at(0).position.y ==
        doctest::Approx(6.096));
  CHECK(metres_of(CodeUnit::kMetre) == 1);
  CHECK(metres_of(CodeUnit::kUsFoot) / metres_of(CodeUnit::kFoot) == doctest::Approx(1.000002));
}

TEST_CASE("code_list__takes_tabs") {
  CHECK(read("1\t2\t3\t4\t360").points.at(0).position == Vec3{2, 3, 4});
}

TEST_CASE("code_list__a_byte_order_mark_is_no_part_of_the_first_id") {
  CHECK(read("\xEF\xBB\xBF"
             "1;2;3;4;360")
            .points.at(0)
            .id == "1");
}

TEST_CASE("code_list__other_separators_are_told") {
  CHECK_THROWS_WITH_AS(read("1,2,3,4,360"), doctest::Contains("semicolons or tabs"), Error);
}

TEST_CASE("code_list__unknown_codes_are_listed_with_line_and_point") {
  const CodeList list = read("1;0;0;0;360\n2;0;0;0;777.2\n3;0;0;0;wall\n4;0;0;0;");
  CHECK(list.points.size() == 1);
  REQUIRE(list.warnings.size() == 3);
  CHECK(list.warnings[0].line == 2);
  CHECK(list.warnings[0].object == "point 2");
  CHECK(list.warnings[0].text.find("777.2") != std::string::npos);
  CHECK(list.warnings[1].text.find("wall") != std::string::npos);
  CHECK(list.warnings[2].line == 4);
}

TEST_CASE("code_list__a_line_that_cannot_be_read_is_named") {
  const auto refused = [](const char* text, const char* part) {
    try {
      read(text);
    } catch (const Error& error) {
      CHECK(error.status() == Status::kFormat);
      CHECK(std::string(error.what()).find(part) != std::string::npos);
      return;
    }
    FAIL("taken");
  };
  refused("1;0;0;0;360\n2;0;0;360", "line 2");
  refused("1;0;0;0;360\n2;0;x;0;360", "line 2");
  refused("1;0;0;0;360\n2;0;nan;0;360", "line 2");
}

TEST_CASE("code_list__a_first_point_that_cannot_be_read_is_no_heading") {
  for (const char* first :
       {"1;1,5;2,5;3,5;360", "1;nan;2;3;360", "1;;2;3;360", "1;;;;360", "1;nan;nan;nan;360"})
    CHECK_THROWS_WITH_AS(read(std::string(first) + "\n2;4;5;6;360"),
                         doctest::Contains("line 1: X, Y and Z of point 1"), Error);
  CHECK(read("ID;X [m];Y [m];Z [m];code\n2;4;5;6;360").points.size() == 1);
}

TEST_CASE("code_list__a_decimal_comma_is_told") {
  CHECK_THROWS_WITH_AS(read("1;1,5;2,5;3,5;360"), doctest::Contains("not a comma"), Error);
}

TEST_CASE("code_list__an_id_that_comes_again_is_a_warning_that_names_both_lines") {
  const CodeList list = read("1;0;0;0;360\n1;0;0;0;360\n1;9;0;0;361\n1;0;0;0;361");
  CHECK(list.points.size() == 4);
  REQUIRE(list.warnings.size() == 2);
  CHECK(list.warnings[0].line == 2);
  CHECK(list.warnings[0].object == "point 1");
  CHECK(list.warnings[0].text.find("line 1") != std::string::npos);
  CHECK(list.warnings[1].line == 3);
}
