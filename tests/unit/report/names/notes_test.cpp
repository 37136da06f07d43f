// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Notes against the JSON that was given, and what is refused by its name.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "report/names/notes.h"
#include "unit/compare/refusal.h"

using namespace jalon;

TEST_CASE("notes__members_keep_their_order_and_the_value_given_last") {
  const Notes notes = read_notes(R"({"times": {"z": 1, "a": 2.5, "z": 3},
      "input": {"b": "1", "a": "2", "b": "3", "c": "4", "a": "5"}, "title": "x", "title": "y"})");
  CHECK(notes.title == "y");
  CHECK(notes.input ==
        std::vector<std::pair<std::string, std::string>>{{"b", "3"}, {"a", "5"}, {"c", "4"}});
  CHECK(notes.times_s == std::vector<std::pair<std::string, double>>{{"z", 3}, {"a", 2.5}});
}

TEST_CASE("notes__numbers_and_booleans_of_the_input_are_text_as_they_were_written") {
  const Notes notes = read_notes(
      R"({"input": {"n": 9007199254740993, "x": 0.1, "yes": true, "no": false, "t": "\u00e9"}})");
  REQUIRE(notes.input.size() == 5);
  CHECK(notes.input[0].second == "9007199254740993");  // 2^53 + 1: no double holds it
  CHECK(notes.input[1].second == "0.1");
  CHECK(notes.input[2].second == "yes");
  CHECK(notes.input[3].second == "no");
  CHECK(notes.input[4].second == "\xC3\xA9");
}

TEST_CASE("notes__what_is_not_told_stays_at_its_default_and_other_members_are_ignored") {
  for (const char* text : {"", "{}", R"({"more": [1, {"title": "inner"}]})"}) {
    CAPTURE(text);
    const Notes notes = read_notes(text);
    CHECK(notes.title == Notes{}.title);
    CHECK(notes.input.empty());
    CHECK(notes.scanner_json.empty());
    CHECK(notes.times_s.empty());
  }
  const char* scanner = R"({"sigma_range_m": 0.0040, "by": {"a": [1, null, "\n"]}})";
  const Notes notes = read_notes(std::string(R"({"scanner": )") + scanner + "}");
  CHECK(nlohmann::json::parse(notes.scanner_json) == nlohmann::json::parse(scanner));
}

TEST_CASE("notes__are_refused_with_the_name_of_what_is_wrong") {
  const std::pair<const char*, const char*> wrong[] = {
      {R"({"input": {"good": 1, "bad one": null}})", "\"bad one\""},
      {R"({"times": {"good": 1, "slow": "2 s"}})", "\"slow\""},
      {R"({"times": {"flag": true}})", "\"flag\""},
      {R"({"scanner": "RTC360"})", "\"scanner\""},
      {R"({"input": "a.las"})", "\"input\""},
      {R"({"title": ["a"]})", "\"title\""},
      {R"([{"title": "a"}])", "object"}};
  for (const auto& notes : wrong) {
    const char* const name = notes.second;
    const auto read = [json = notes.first] { read_notes(json); };
    CHECK_MESSAGE(test::refuses(read, Status::kInvalidArgument, name), name);
  }
}
