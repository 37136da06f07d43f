// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/grouping.h"

#include <doctest/doctest.h>

#include <map>

#include "geometry/polygon2.h"
#include "unit/segment/codes/coded.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("grouping__the_annex_has_4_buildings_19_doors_100_windows_and_12_gutters") {
  std::map<std::string, int> kinds;
  const CodedObjects all = surveyed(code_list_of(kAnnexSurvey));
  for (const CodedObject& object : all.objects) ++kinds[object.row.name];
  CHECK(kinds["building"] == 4);
  CHECK(kinds["door"] == 19);
  CHECK(kinds["window"] == 100);
  CHECK(kinds["gutter"] == 12);
  CHECK(all.objects.size() == 135);
  CHECK(object_named(all, "building 156")->points.size() == 13);
}

TEST_CASE("grouping__window_targets_of_the_annex_pair_up_on_their_facades") {
  const CodeTable table = code_table_from_json(kTargetCodeTable);
  const CodedObjects targets =
      grouped_objects(read_code_list(code_list_of(kAnnexTargets), table), table);
  CHECK(targets.objects.size() == 25);
  CHECK(targets.warnings.empty());
  const CodedObjects survey = surveyed(code_list_of(kAnnexSurvey));
  const auto corner = [&](const char* id) {
    for (const CodedObject& building : survey.objects)
      for (const CodedPoint& p : building.points)
        if (p.id == id) return in_plan(p.position);
    return Vec2{};
  };
  const char* pairs[][4] = {{"101", "102", "601", "500"},
                            {"105", "106", "254", "100"},
                            {"107", "108", "650", "255"},
                            {"122", "123", "200", "201"},
                            {"125", "133", "256", "257"}};
  for (const auto& [one, second, from, to] : pairs) {
    const char* const first = one;
    CAPTURE(first);
    const CodedObject* windows = object_named(targets, std::string("windows ") + first);
    REQUIRE(windows != nullptr);
    REQUIRE(windows->points.size() == 2);
    CHECK(windows->points[1].id == second);
    for (const CodedPoint& p : windows->points)
      CHECK(segment_distance(in_plan(p.position), corner(from), corner(to)) < 0.3);
  }
}

TEST_CASE("grouping__sequences_may_be_interleaved") {
  const CodedObjects all = surveyed(
      "1;0;0;3;300.2\n2;50;0;3;301.2\n3;9;0;3;300.4\n4;59;0;3;301.4\n5;59;9;3;301.4\n6;9;9;3;300."
      "4\n"
      "7;1;0;1;360\n8;0;0;0;408\n9;2;0;2;360\n10;0.04;0;0;409\n11;5;5;0;300.4\n12;0;0;2;410\n"
      "13;80;0;3;300.2\n14;90;0;3;300.4\n15;90;9;3;300.4\n");
  REQUIRE(object_named(all, "building 1") != nullptr);
  CHECK(object_named(all, "building 1")->points.size() == 4);
  CHECK(object_named(all, "building 2")->points.size() == 3);
  CHECK(object_named(all, "building 13")->points.size() == 3);
  CHECK(object_named(all, "window 7")->points.back().id == "9");
  CHECK(object_named(all, "gutter 8")->points.back().id == "12");
}

TEST_CASE("grouping__a_point_measured_twice_is_used_once_and_told") {
  // Else the second window would be of the first one's last corner, and so on to the end of the list.
  const CodedObjects all = surveyed(
      "1;0;0;1;360\n2;2;0;2;360\n3;2.002;0;2;360\n4;4;0;1;360\n5;6;0;2;360\n6;6;0;0;408\n"
      "7;6;0;0;408\n8;6.04;0;0;409\n9;6;0;3;410\n");
  REQUIRE(object_named(all, "window 4") != nullptr);
  CHECK(object_named(all, "window 4")->points.back().id == "5");
  CHECK(object_named(all, "gutter 6") != nullptr);
  CHECK(all.objects.size() == 3);
  CHECK(warning_of(all, "window 3").line == 3);
  CHECK(warning_of(all, "window 3").text.find("2 mm from point 2 of line 2") != std::string::npos);
  CHECK(warning_of(all, "gutter 7").line == 7);
  CHECK(all.warnings.size() == 2);
  // Of one point two codes are two points.
  CHECK(surveyed("1;0;0;1;360+360\n").warnings[0].text.find("above") != std::string::npos);
}

TEST_CASE("grouping__an_opening_that_lacks_a_corner_is_named_and_those_behind_it_keep_theirs") {
  // Windows of 2 m every 3 m, five of each way to measure them; of one a point is missing.
  const auto windows = [](int code, size_t missing) {
    const auto line = [](size_t id, double x, double y, double z, const std::string& code_text) {
      return std::to_string(id) + ";" + std::to_string(x) + ";" + std::to_string(y) + ";" +
             std::to_string(z) + ";" + code_text + "\n";
    };
    const std::string c = std::to_string(code);
    std::vector<std::string> lines;
    for (size_t w = 0; w < 5; ++w) {
      const double x = 3.0 * static_cast<double>(w);
      const size_t id = 10 * w;
      if (code == 362) {
        lines.push_back(line(id, x, 0, 0.9, c));
        lines.push_back(line(id + 1, x + 2, 0, 0.9, c));
        lines.push_back(line(id + 2, x + 2, 0.2, 1, c + ".8"));
        lines.push_back(line(id + 3, x + 2, 0.2, 2, c + ".8"));
      } else {
        lines.push_back(line(id, x, 0, 1, c));
        if (code == 361) lines.push_back(line(id + 1, x, 0.2, 1, c + ".8"));
        lines.push_back(line(id + 2, x + 2, 0, 2, c));
      }
    }
    std::string text;
    for (size_t k = 0; k < lines.size(); ++k)
      if (k != missing) text += lines[k];
    return text;
  };
  for (const int code : {360, 361, 362}) {
    const size_t wanted = static_cast<size_t>(code) - 358;
    for (size_t k = 0; k < wanted; ++k) {
      CAPTURE(code);
      CAPTURE(k);
      const CodedObjects all = surveyed(windows(code, 2 * wanted + k));
      CHECK(all.objects.size() == 4);
      REQUIRE(all.warnings.size() == 1);
      CHECK(all.warnings[0].object.starts_with("window 2"));
      CHECK(all.warnings[0].text.find("those behind it keep their own") != std::string::npos);
      REQUIRE(object_named(all, "window 30") != nullptr);
      const CodeShape& shape = object_named(all, "window 30")->shape;
      CHECK(std::fabs(norm(in_plan(shape.corner_b - shape.corner_a)) - 2) < 1e-9);
      CHECK(object_named(all, "window 40") != nullptr);
    }
  }
  // Where nothing tells which point is missing the last is left out, and the warning says so.
  const CodedObjects all = surveyed(windows(360, 0));
  CHECK(all.objects.size() == 4);
  CHECK(warning_of(all, "window 42").text.find("may be missing") != std::string::npos);
}

TEST_CASE("grouping__a_closing_point_ends_its_linkage") {
  const CodedObjects all = surveyed(
      "1;0;0;1;365.2\n2;1;0;1;365.4\n3;1;0;2;365.0\n4;5;0;1;365.4\n5;8;0;1;365.2\n6;9;0;1;365.4\n"
      "7;9;0;2;365.0\n");
  CHECK(object_named(all, "window 1")->points.size() == 3);
  CHECK(object_named(all, "window 5")->points.size() == 3);
  CHECK(warning_of(all, "window 4").line == 4);
}

TEST_CASE("grouping__what_is_incomplete_names_line_and_object") {
  const CodedObjects all = surveyed(
      "1;0;0;0;408\n2;0.04;0;0;409\n3;5;0;0;408\n4;5.04;0;0;409\n5;5;0;3;410\n6;7;0;0;409\n"
      "7;0;0;0;361\n8;0;0;1;361.8\n9;0;0;3;300.4\n");
  CHECK(all.objects.size() == 1);
  CHECK(warning_of(all, "gutter 1").line == 2);
  CHECK(warning_of(all, "gutter 1").text.find("2 of 3") != std::string::npos);
  CHECK(warning_of(all, "gutter 6").line == 6);
  CHECK(warning_of(all, "window 7").text.find("2 of 3") != std::string::npos);
  CHECK(warning_of(all, "building 9").text.find("start") != std::string::npos);
}
