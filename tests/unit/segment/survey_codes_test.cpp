// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "segment/codes_methods.h"
#include "unit/segment/codes/annex.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const char* const kHouse =
    "1;0;0;3;300.2\n2;10;0;3;300.4\n3;10;8;3;300.4\n4;0;8;3;300.4\n5;0;0;0;300.4\n"
    "6;1;0.1;0;350\n7;2;0.1;2;350\n8;5;0.2;1;360\n9;7;0.2;2;360\n"
    "10;-0.05;4;0;408\n11;-0.09;4;0;409\n12;-0.05;4;2.8;410\n13;30;30;1;360\n14;31;30;2;360\n";

/// The front wall, its door and window, a gutter, the ground, each on a grid of 5 cm.
CloudPtr house() {
  std::vector<Vec3> points;
  for (double x = 0.025; x < 10; x += 0.05)
    for (double z = 0.025; z < 3; z += 0.05) points.push_back({x, 0, z});
  for (double x = 1.025; x < 2; x += 0.05)
    for (double z = 0.025; z < 2; z += 0.05) points.push_back({x, 0.1, z});
  for (double x = 5.025; x < 7; x += 0.05)
    for (double z = 1.025; z < 2; z += 0.05) points.push_back({x, 0.21, z});
  for (double z = 0.025; z < 2.8; z += 0.05)
    for (int k = 0; k < 12; ++k)
      points.push_back({-0.05 + 0.04 * std::cos(0.5236 * k), 4 + 0.04 * std::sin(0.5236 * k), z});
  for (int x = 0; x < 200; ++x)
    for (int y = 0; y < 45; ++y) points.push_back({-5 + 0.1 * x, -5 + 0.1 * y, 0});
  Cloud cloud = *cloud_of(points);
  auto column =
      std::make_shared<Column>(FieldInfo{"intensity", ElementType::kUint16}, points.size());
  for (size_t i = 0; i < points.size(); ++i)
    column->values<uint16_t>()[i] = static_cast<uint16_t>(i);
  cloud.fields.set(column);
  return std::make_shared<const Cloud>(std::move(cloud));
}

Segmentation coded(const CloudPtr& cloud, const std::string& codes,
                   ClassScheme classes = ClassScheme::kTable, unsigned threads = 0) {
  SurveyCodeSettings settings;
  settings.input.codes = codes;
  settings.input.classes = classes;
  Task task(Task::Hooks{.threads = threads});
  return segment_by_survey_codes(cloud, settings, task);
}

std::map<int, size_t> class_counts(const Segmentation& s) {
  std::map<int, size_t> counts;
  for (const uint8_t c : s.cloud->fields.require("classification").values<uint8_t>()) ++counts[c];
  return counts;
}

}  // namespace

TEST_CASE("survey_codes__every_point_has_the_class_and_object_of_its_codes") {
  const CloudPtr cloud = house();
  const Segmentation s = coded(cloud, kHouse);
  const auto counts = class_counts(s);
  CHECK(counts.at(1) == 200 * 60);
  CHECK(counts.at(2) == 20 * 40);
  CHECK(counts.at(3) == 40 * 20);
  CHECK(counts.at(4) == 56 * 12);
  CHECK(counts.at(0) == 200 * 45);
  CHECK(s.segments.size() == 4);
  CHECK(s.cloud->size() == cloud->size());
  CHECK(s.cloud->fields.find("intensity") == cloud->fields.find("intensity"));
  CHECK(s.cloud->fields.find("jalon:object") == nullptr);
  CHECK(s.segments[0].source_label == 1);
  CHECK(!s.segments[0].has_plane());
  CHECK(s.segments[0].point_count() == 200 * 60);
  for (const Segment& segment : s.segments)
    if (segment.source_label == 3)
      CHECK(std::fabs(segment.fit.plane.offset) == doctest::Approx(0.21));
}

TEST_CASE("survey_codes__a_gutter_is_the_cylinder_that_was_measured") {
  const Segmentation s = coded(house(), kHouse);
  for (const Segment& segment : s.segments)
    if (segment.source_label == 4) {
      CHECK(segment.type == PrimitiveType::kCylinder);
      CHECK(segment.cylinder.cylinder.radius == doctest::Approx(0.04));
      CHECK(segment.cylinder.length_m == doctest::Approx(2.8));
      CHECK(segment.point_count() == 56 * 12);
    }
  const auto labels = s.labels->values<uint32_t>();
  const auto residuals = s.residuals->values<float>();
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0 && s.segments[labels[i] - 1].source_label == 4)
      CHECK(std::fabs(residuals[i]) < 1e-5f);
}

TEST_CASE("survey_codes__notes_tell_objects_classes_and_warnings") {
  const auto notes = nlohmann::json::parse(coded(house(), kHouse).notes_json);
  CHECK(notes["method"] == "survey_codes");
  REQUIRE(notes["objects"].size() == 5);
  CHECK(notes["objects"][0]["name"] == "building 1");
  CHECK(notes["objects"][0]["shape"] == "prism");
  CHECK(notes["objects"][0]["outline"].size() == 4);
  CHECK(notes["objects"][1]["hinge"] == "left");
  CHECK(notes["objects"][2]["corners"][1][0] == 7);
  CHECK(notes["objects"][3]["lines"] == nlohmann::json{10, 11, 12});
  CHECK(notes["objects"][3]["radius_m"].get<double>() == doctest::Approx(0.04));
  CHECK(notes["objects"][4]["points"] == 0);
  CHECK(notes["objects"][4]["label"] == 0);
  CHECK(notes["classes"].size() == 5);
  REQUIRE(notes["warnings"].size() == 2);
  CHECK(notes["warnings"][0]["line"] == 13);
  CHECK(notes["warnings"][0]["object"] == "window 13");
}

TEST_CASE("survey_codes__warnings_reach_the_log") {
  std::vector<std::string> lines;
  Task::Hooks hooks;
  hooks.log = [](int32_t level, const char* text, void* user) {
    if (level == Task::kWarning) static_cast<std::vector<std::string>*>(user)->push_back(text);
  };
  hooks.log_user = &lines;
  SurveyCodeSettings settings;
  settings.input.codes = std::string(kHouse) + "20;0;0;0;888\n21;0;0;0;408\n22;0;0;0;409\n";
  Task task(hooks);
  segment_by_survey_codes(house(), settings, task);
  REQUIRE(lines.size() == 4);
  CHECK(lines[2] == "code list, line 15: point 20: unknown code \"888\": not used");
  CHECK(lines[3] == "code list, line 17: gutter 21: has 2 of 3 points: left out");
}

TEST_CASE("survey_codes__asprs_numbers_are_a_choice") {
  const auto counts = class_counts(coded(house(), kHouse, ClassScheme::kAsprs));
  CHECK(counts.at(6) == 200 * 60);
  CHECK(counts.at(64) == 20 * 40);
  CHECK(counts.at(65) == 40 * 20);
  CHECK(counts.at(66) == 56 * 12);
  CHECK(counts.at(1) == 200 * 45);
}

TEST_CASE("survey_codes__no_codes_make_no_segments") {
  const Segmentation s = coded(house(), "");
  CHECK(s.segments.empty());
  CHECK(class_counts(s).at(0) == s.cloud->size());
}

TEST_CASE("survey_codes__far_coordinates_and_threads_change_nothing") {
  const Vec3 far{734500, 642100, 200};
  std::vector<Vec3> points;
  const CloudPtr near = house();
  for (size_t i = 0; i < near->size(); ++i) points.push_back(near->point(i));
  std::string codes;
  for (const auto& line :
       {"1;734500;642100;203;300.2", "2;734510;642100;203;300.4", "3;734510;642108;203;300.4",
        "4;734500;642108;203;300.4", "5;734500;642100;200;300.4", "6;734501;642100.1;200;350",
        "7;734502;642100.1;202;350"})
    codes += std::string(line) + "\n";
  const Segmentation one = coded(cloud_of(points, far), codes, ClassScheme::kTable, 1);
  const Segmentation four = coded(cloud_of(points, far), codes, ClassScheme::kTable, 4);
  CHECK(class_counts(one).at(2) == 20 * 40);
  CHECK(one.notes_json == four.notes_json);
  const auto a = one.labels->values<uint32_t>(), b = four.labels->values<uint32_t>();
  CHECK(std::equal(a.begin(), a.end(), b.begin()));
}

TEST_CASE("survey_codes__a_table_of_ones_own_says_what_codes_mean") {
  SurveyCodeSettings settings;
  settings.input.table =
      R"({"codes": [{"from": 7, "name": "hatch", "geometry": "two_corners", "class": 9,
                     "distance_m": 0.05}]})";
  settings.input.codes = "1;5;0.2;1;7\n2;7;0.2;2;7\n";
  Task task;
  const Segmentation s = segment_by_survey_codes(house(), settings, task);
  CHECK(class_counts(s).at(9) == 40 * 20);
  settings.input.table = "{";
  CHECK_THROWS_AS(segment_by_survey_codes(house(), settings, task), Error);
}
