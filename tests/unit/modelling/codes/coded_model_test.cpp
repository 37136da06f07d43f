// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/coded_model.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "base/error.h"
#include "segment/codes_methods.h"
#include "unit/modelling/model_checks.h"
#include "unit/segment/codes/annex.h"
#include "unit/segment/codes/target_house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Nothing of the objects but what the codes say: the points lie elsewhere.
CloudPtr three_points(const Vec3& at) { return cloud_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, at); }

Segmentation surveyed_on(const CloudPtr& cloud, const std::string& codes) {
  SurveyCodeSettings settings;
  settings.input.codes = codes;
  Task task;
  return segment_by_survey_codes(cloud, settings, task);
}

Model modelled(const Segmentation& segmentation) {
  Task task;
  Model model = model_coded_objects(segmentation, {}, task);
  validate(model);
  return model;
}

std::map<std::string, size_t> classes_of(const Model& model) {
  std::map<std::string, size_t> counts;
  for (const Part& part : model.parts) ++counts[part.part_class];
  return counts;
}

const Part* part_named(const Model& model, const std::string& name) {
  for (const Part& part : model.parts)
    if (part.name == name) return &part;
  return nullptr;
}

const char* const kHouse =
    "1;0;0;3;300.2\n2;10;0;3;300.4\n3;10;8;3;300.4\n4;0;8;3;300.4\n5;0;0;0;300.4\n"
    "6;1;0.1;0;350\n7;2;0.1;2;350\n8;5;0.2;1;360\n9;7;0.2;2;360\n"
    "10;-0.05;4;0;408\n11;-0.09;4;0;409\n12;-0.05;4;2.8;410\n13;30;30;1;360\n14;31;30;2;360\n";

}  // namespace

TEST_CASE("coded_model__of_the_annex_has_every_object_and_closed_buildings") {
  const Model model =
      modelled(surveyed_on(three_points({734500, 642100, 246}), code_list_of(kAnnexSurvey)));
  const auto classes = classes_of(model);
  CHECK(classes.at("building") == 4);
  CHECK(classes.at("door") == 19);
  CHECK(classes.at("window") == 98);  // two of the list contradict themselves
  CHECK(classes.at("gutter") == 12);
  REQUIRE(model.solids.size() == 4 + 12);
  for (const Solid& solid : model.solids) {
    CAPTURE(model.parts[solid.part].name);
    CHECK(checks::solid_fault(model, solid) == "");
  }
  for (const Face& face : model.faces) {
    CAPTURE(model.parts[face.part].name);
    CHECK(checks::ring_fault(model, face) == "");
    CHECK(checks::flatness(model, face) < 1e-7);
  }
  // Nearly every opening stands in a wall of its building.
  size_t in_wall = 0;
  for (const Part& part : model.parts)
    in_wall +=
        (part.part_class == "window" || part.part_class == "door") && part.parent != kNoParent;
  CHECK(in_wall == 117);
  const Part* window = part_named(model, "window 220 (362)");
  REQUIRE(window != nullptr);
  CHECK(window->depth_m == doctest::Approx(0.16).epsilon(0.04).scale(0));
  CHECK(window->width_m == doctest::Approx(1.99).epsilon(0.01));
}

TEST_CASE("coded_model__volumes_are_those_of_the_outlines_less_the_recesses") {
  const Model model = modelled(surveyed_on(three_points({}), kHouse));
  REQUIRE(model.solids.size() == 2);
  const Vec3 inside{5, 4, 1};
  double volume = 0;
  for (uint64_t f = 0; f < model.solids[0].face_count; ++f) {
    const Face& face = model.faces[model.solids[0].first_face + f];
    volume -= face.area_m2 * face.plane.distance(inside) / 3;
  }
  CHECK(volume == doctest::Approx(10 * 8 * 3 - 1 * 0.1 * 2 - 2 * 0.2 * 1));
  CHECK(checks::solid_fault(model, model.solids[0]) == "");
  const auto classes = classes_of(model);
  CHECK(classes.at("window") == 2);
  CHECK(classes.at("gutter") == 1);
  CHECK(part_named(model, "window 13 (360)")->parent == kNoParent);  // no wall holds it
  const Part* gutter = part_named(model, "gutter 10 (408)");
  REQUIRE(gutter != nullptr);
  CHECK(model.parts[gutter->parent].part_class == "building");
  CHECK(model.parts[0].level_of_detail == 3);
}

TEST_CASE("coded_model__either_order_of_an_outline_gives_the_same_walls") {
  const std::string turned =
      "1;0;0;3;300.2\n2;0;8;3;300.4\n3;10;8;3;300.4\n4;10;0;3;300.4\n5;0;0;0;300.4\n"
      "6;1;0.1;0.1;350\n7;2;0.1;2;350\n";
  const Model model = modelled(surveyed_on(three_points({}), turned));
  REQUIRE(model.solids.size() == 1);
  CHECK(checks::solid_fault(model, model.solids[0]) == "");
  CHECK(part_named(model, "door 6 (350)")->parent != kNoParent);
}

TEST_CASE("coded_model__of_targets_has_the_rectangles_of_their_points") {
  const TargetHouse house;
  const Model model = modelled(house.coded(house.targets));
  const auto classes = classes_of(model);
  CHECK(classes.at("wall") == 1);
  CHECK(classes.at("door") == 1);
  CHECK(classes.at("window") == 2);  // apart by a metre of wall
  CHECK(classes.at("gutter") == 1);
  const Part* door = part_named(model, "door 2 (2)");
  REQUIRE(door != nullptr);
  CHECK(door->width_m == doctest::Approx(1).epsilon(0.05));
  CHECK(door->height_m == doctest::Approx(2).epsilon(0.05));
  CHECK(door->depth_m == doctest::Approx(0.12).epsilon(0.05).scale(0));
  for (const Face& face : model.faces) CHECK(checks::ring_fault(model, face) == "");
  double radius = 0;
  size_t corners = 0;
  for (const Face& face : model.faces)
    if (model.parts[face.part].part_class == "gutter")
      for (uint64_t c = 0; c < model.rings[face.first_ring].count; ++c, ++corners) {
        const Vec3& p = model.vertices[model.corners[model.rings[face.first_ring].first + c]];
        radius += std::hypot(p.x - 9.7, p.y + 0.15);
      }
  CHECK(radius / static_cast<double>(corners) == doctest::Approx(0.04).epsilon(0.02).scale(0));
}

TEST_CASE("coded_model__without_codes_is_empty_or_told") {
  CHECK(modelled(surveyed_on(three_points({}), "")).faces.empty());
  Segmentation other = surveyed_on(three_points({}), "");
  other.notes_json.clear();
  Task task;
  CHECK(model_coded_objects(other, {}, task).faces.empty());
  other.segments.resize(1);
  CHECK_THROWS_AS(model_coded_objects(other, {}, task), Error);
}

TEST_CASE("coded_model__a_building_without_a_low_point_stands_where_its_points_end") {
  const std::string codes = "1;0;0;3;300.2\n2;10;0;3;300.4\n3;10;8;3;300.4\n4;0;8;3;300.4\n";
  CHECK(modelled(surveyed_on(three_points({50, 50, 0}), codes)).faces.empty());
  std::vector<Vec3> wall;
  for (int i = 1; i < 100; ++i)
    for (int k = 0; k <= 30; ++k) wall.push_back({0.1 * i, 0, 0.1 * k - 0.5});
  const Model model = modelled(surveyed_on(cloud_of(wall), codes));
  REQUIRE(model.solids.size() == 1);
  double low = INFINITY;
  for (const Vec3& p : model.vertices) low = std::min(low, p.z);
  CHECK(low == doctest::Approx(-0.5));
}
