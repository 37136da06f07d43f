// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/coded_result.h"

#include <doctest/doctest.h>

#include "unit/segment/codes/coded.h"
#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Two openings; of nine points four lie in the first, three in the second, two in none.
struct Made {
  CodedObjects objects = surveyed("1;0;0;0;350\n2;1;0;1;350\n3;5;0;0;360\n4;6;0;1;360\n");
  CloudPtr cloud = cloud_of({{0, 0, 0},
                             {1, 0, 0},
                             {1, 0, 1},
                             {0, 0, 1},
                             {5, 0, 0},
                             {6, 0, 0},
                             {6, 0, 1},
                             {9, 1, 0},
                             {9, 2, 0}});
  std::vector<uint32_t> object_of_point{1, 1, 1, 1, 2, 2, 2, 0, 0};
};

}  // namespace

TEST_CASE("coded_result__segments_come_largest_first_and_keep_their_objects_number") {
  Made made;
  made.object_of_point = {0, 1, 1, 0, 2, 2, 2, 0, 0};
  Task task;
  const Segmentation s =
      coded_segmentation(made.cloud, made.object_of_point, made.objects, {}, "survey_codes", task);
  REQUIRE(s.segments.size() == 2);
  CHECK(s.segments[0].source_label == 2);
  CHECK(s.segments[0].point_count() == 3);
  CHECK(s.segments[1].source_label == 1);
  const auto classes = s.cloud->fields.require("classification").values<uint8_t>();
  CHECK(std::vector<uint8_t>(classes.begin(), classes.end()) ==
        std::vector<uint8_t>{0, 2, 2, 0, 3, 3, 3, 0, 0});
  const auto labels = s.labels->values<uint32_t>();
  CHECK(labels[1] == 2);
  CHECK(labels[4] == 1);
}

TEST_CASE("coded_result__replaces_a_classification_that_the_cloud_had") {
  Made made;
  Cloud cloud = *made.cloud;
  auto before = std::make_shared<Column>(FieldInfo{"classification", ElementType::kUint16}, 9);
  for (uint16_t& c : before->values<uint16_t>()) c = 77;
  cloud.fields.set(before);
  Task task;
  const Segmentation s = coded_segmentation(std::make_shared<const Cloud>(cloud),
                                            made.object_of_point, made.objects, {}, "x", task);
  CHECK(s.cloud->fields.require("classification").values<uint8_t>()[8] == 0);
}

TEST_CASE("coded_result__warns_of_objects_without_points_and_points_far_away") {
  Made made;
  made.objects.objects[1].points[1].position = {6, 0, 5000};
  Task task;
  warn_of_empty(*made.cloud, made.object_of_point, made.objects, task);
  REQUIRE(made.objects.warnings.size() == 1);
  CHECK(made.objects.warnings[0].line == 4);
  CHECK(made.objects.warnings[0].text == "point 4 lies 4999 m outside the cloud");
  made.object_of_point.assign(9, 2);
  made.objects.warnings.clear();
  made.objects.objects[1].points[1].position = {6, 0, 1};
  warn_of_empty(*made.cloud, made.object_of_point, made.objects, task);
  REQUIRE(made.objects.warnings.size() == 1);
  CHECK(made.objects.warnings[0].object == "door 1");
  CHECK(made.objects.warnings[0].text == "holds no point of the cloud");
}
