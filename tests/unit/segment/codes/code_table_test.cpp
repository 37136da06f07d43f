// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/code_table.h"

#include <doctest/doctest.h>

#include "base/error.h"

using namespace jalon;

TEST_CASE("code_table__ready_made_tables_know_the_codes_of_the_text") {
  const CodeTable targets = code_table_from_json(kTargetCodeTable);
  for (const int64_t code : {1, 2, 3, 4}) {
    REQUIRE(targets.find(code) != nullptr);
    CHECK(targets.find(code)->class_code == code);
  }
  CHECK(targets.find(99)->geometry == CodeGeometry::kIgnored);
  CHECK(targets.find(5) == nullptr);
  const CodeTable survey = code_table_from_json(kSurveyCodeTable);
  for (int64_t code = 0; code < 6; ++code)
    for (const int64_t first : {100, 300})
      CHECK(survey.find(first + code)->geometry == CodeGeometry::kPrism);
  CHECK(survey.find(351)->geometry == CodeGeometry::kThreePoints);
  CHECK(survey.find(362)->geometry == CodeGeometry::kFourPoints);
  CHECK(survey.find(365)->geometry == CodeGeometry::kOutline);
  CHECK(survey.find(350)->distance_m == 0.04);
  CHECK(survey.find(360)->distance_m == 0.03);
  CHECK(survey.find(410)->geometry == CodeGeometry::kCylinderTop);
  CHECK(survey.find(306) == nullptr);
}

TEST_CASE("code_table__reads_a_table_of_ones_own") {
  const CodeTable table = code_table_from_json(
      R"({"name": "roads", "separator": "/", "modifiers": {"start": 1, "close": 9},
          "codes": [{"from": 7, "to": 9, "name": "kerb", "geometry": "line"}]})");
  CHECK(table.name == "roads");
  CHECK(table.separator == '/');
  CHECK(table.modifiers.start == 1);
  CHECK(table.modifiers.next == 4);
  CHECK(table.modifiers.close == 9);
  CHECK(table.find(8)->name == "kerb");
}

TEST_CASE("code_table__what_is_no_json_is_told_of_the_table") {
  CHECK_THROWS_WITH_AS(code_table_from_json("from;to\n"), doctest::Contains("code table: no JSON"),
                       Error);
}

TEST_CASE("code_table__refuses_what_is_no_table_and_says_why") {
  const auto refused = [](const char* text, const char* part) {
    CAPTURE(text);
    try {
      code_table_from_json(text);
    } catch (const Error& error) {
      CHECK(error.status() == Status::kFormat);
      CHECK(std::string(error.what()).find(part) != std::string::npos);
      return;
    }
    FAIL("taken");
  };
  refused("[]", "no JSON object");
  refused("{}", "\"codes\"");
  refused(R"({"codes": [3]})", "objects");
  refused(R"({"codes": [{"name": "x", "geometry": "line"}]})", "\"from\"");
  refused(R"({"codes": [{"from": 3, "geometry": "line"}]})", "\"name\"");
  refused(R"({"codes": [{"from": 3, "name": "x", "geometry": "blob"}]})", "\"blob\"");
  refused(R"({"codes": [{"from": 3, "to": 2, "name": "x", "geometry": "line"}]})", "below");
  refused(R"({"codes": [{"from": -3, "name": "x", "geometry": "line"}]})", "whole number");
  refused(R"({"codes": [{"from": 3, "name": "x", "geometry": "line", "class": 256}]})", "255");
  refused(R"({"codes": [{"from": 3, "name": "x", "geometry": "line", "distance_m": 0}]})",
          "length");
  refused(R"({"codes": [{"from": 3, "to": 6, "name": "x", "geometry": "line"},
                        {"from": 5, "name": "y", "geometry": "line"}]})",
          "share");
  refused(R"({"separator": ".", "codes": []})", "separator");
  refused(R"({"codes": [{"from": 3, "name": "x", "geometry": "prism"}]})", "x has no \"class\"");
  refused(R"({"codes": [{"from": 3, "name": "x", "geometry": "line", "distance": 1}]})",
          "no \"distance\"");
}
