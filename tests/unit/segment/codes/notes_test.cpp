// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/notes.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "unit/segment/codes/coded.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("notes__shapes_are_told_in_the_coordinates_of_the_list") {
  const CodedObjects all = surveyed(code_list_of(kAnnexSurvey));
  const std::vector<uint32_t> labels(all.objects.size(), 7);
  const std::vector<uint64_t> points(all.objects.size(), 11);
  const auto notes =
      nlohmann::json::parse(coded_notes("survey_codes", all, labels, points, {{0, 3}, {1, 11}}));
  REQUIRE(notes["objects"].size() == 135);
  for (const auto& object : notes["objects"]) {
    CHECK(object["label"] == 7);
    CHECK(object["points"] == 11);
    if (object["name"] == "door 303") {
      CHECK(object["corners"][0][0].get<double>() == doctest::Approx(734571.517).epsilon(1e-9));
      CHECK(object["corners"][1][2].get<double>() == doctest::Approx(248.879));
      CHECK(object["ids"] == nlohmann::json{"303", "304"});
    }
    if (object["name"] == "building 255") {
      CHECK(object["low_m"].get<double>() == doctest::Approx(246.728));
      CHECK(object["outline"][1][1].get<double>() == doctest::Approx(642187.996).epsilon(1e-9));
    }
    if (object["name"] == "gutter 259") {
      CHECK(object["shape"] == "cylinder");
      CHECK(object["axis"][1][2].get<double>() == doctest::Approx(249.527));
    }
  }
  CHECK(notes["classes"][1]["points"] == 11);
  CHECK(notes["warnings"][0]["object"] == "window 181");
}
