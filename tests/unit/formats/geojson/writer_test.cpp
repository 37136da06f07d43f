// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// GeoJSON, read by another JSON library, against RFC 7946 and models of known areas.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>

#include <nlohmann/json.hpp>

#include "formats/geojson/geojson.h"
#include "unit/formats/fixtures.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::test;

namespace {

nlohmann::json geo_file(const Model& model) {
  const Folder folder;
  Task task;
  write_geojson(model, folder.file("a.geojson"), {}, task);
  return nlohmann::json::parse(slurp(folder.file("a.geojson")));
}

/// In plan, positive when anticlockwise; the ring must end where it begins.
double plan_area_m2(const nlohmann::json& ring) {
  REQUIRE(ring.size() >= 4);
  CHECK(ring.front() == ring.back());
  double sum = 0;
  const auto offset = [&](size_t i, size_t axis) {
    return ring[i][axis].get<double>() - ring[0][axis].get<double>();
  };
  for (size_t i = 0; i + 1 < ring.size(); ++i)
    sum += offset(i, 0) * offset(i + 1, 1) - offset(i + 1, 0) * offset(i, 1);
  return sum / 2;
}

std::vector<Vec3> level_box(double x, double y, double width, double depth, bool clockwise) {
  std::vector<Vec3> out{{x, y, 7}, {x + width, y, 7}, {x + width, y + depth, 7}, {x, y + depth, 7}};
  if (clockwise) std::swap(out[1], out[3]);
  return out;
}

std::string system_of(const std::string& crs) {
  Model model;
  model.crs = crs;
  const nlohmann::json file = geo_file(model);
  CHECK(file["type"] == "FeatureCollection");
  CHECK(file["features"].empty());
  CHECK(file["crs"]["type"] == "name");
  return file["crs"]["properties"]["name"].get<std::string>();
}

}  // namespace

TEST_CASE("geojson_writer__outlines_run_anticlockwise_in_plan_and_holes_clockwise") {
  Model model;
  for (const bool looks_down : {false, true}) {
    Face face;
    face.id = looks_down ? 8 : 9;
    face.plane.normal = {0, 0, looks_down ? -1.0 : 1.0};
    model.add_face(face, {level_box(652000, 6861000, 9, 5, looks_down),
                          level_box(652001, 6861001, 2, 1, !looks_down),
                          {},
                          level_box(652005, 6861001, 1, 1, !looks_down)});
  }
  model.add_face({}, {{{0, 0, 0}, {1, 0, 0}}});  // nothing to show
  const nlohmann::json file = geo_file(model);
  REQUIRE(file["features"].size() == 2);
  for (const nlohmann::json& feature : file["features"]) {
    CHECK(feature["type"] == "Feature");
    CHECK(feature["geometry"]["type"] == "Polygon");
    const nlohmann::json& rings = feature["geometry"]["coordinates"];
    REQUIRE(rings.size() == 3);
    CHECK(plan_area_m2(rings[0]) == 45);
    CHECK(plan_area_m2(rings[1]) == -2);
    CHECK(plan_area_m2(rings[2]) == -1);
    for (const nlohmann::json& position : rings[0]) CHECK(position.size() == 3);
    CHECK(feature["properties"]["face"] == (feature["id"] == 0 ? 9 : 8));
    CHECK(feature["properties"]["normal_z"] == (feature["id"] == 0 ? 1 : -1));
  }
}

TEST_CASE("geojson_writer__arcs_are_drawn_within_the_chord_error_and_parts_are_told") {
  Model model = House().model();
  model.parts[2].width_m = INFINITY;  // of the wall
  const nlohmann::json file = geo_file(model);
  // Four openings without a face of their own, one of them with the width of its part.
  REQUIRE(file["features"].size() == model.faces.size() + 4);
  for (size_t k = 0; k < 4; ++k) {
    const nlohmann::json& opening = file["features"][model.faces.size() + k];
    CHECK(opening["id"] == model.faces.size() + k);
    CHECK(opening["geometry"]["type"] == "Polygon");
    CHECK(part_class::is_opening(opening["properties"]["class"].get<std::string>()));
    CHECK(opening["properties"]["part_of"] == model.parts[2].name);
    CHECK_FALSE(opening["properties"].contains("face"));
  }
  for (size_t f = 0; f < model.faces.size(); ++f) {
    const nlohmann::json& told = file["features"][f]["properties"];
    const Part& part = model.parts[model.faces[f].part];
    CHECK(told["class"] == part.part_class);
    CHECK(told["name"] == part.name);
    CHECK(told["part_of"] == model.parts[part.parent].name);
    CHECK(told["area_m2"] == model.faces[f].area_m2);
    CHECK_FALSE(told.contains("width_m"));  // no part with a face has one
  }
  // The round window about the middle of its two corners, each 0.4 m away.
  const nlohmann::json& ring = file["features"][0]["geometry"]["coordinates"][4];
  const auto place = [&](const nlohmann::json& p) {
    return Vec3{p[0].get<double>(), p[1].get<double>(), p[2].get<double>()};
  };
  const Ring& round = model.rings[4];
  const Vec3 first = model.vertices[model.corners[round.first]],
             middle = first + 0.5 * (model.vertices[model.corners[round.first + 1]] - first);
  CHECK(ring.size() > 20);
  for (size_t i = 0; i + 1 < ring.size(); ++i) {
    const Vec3 a = place(ring[i]) - middle, b = place(ring[i + 1]) - middle;
    CHECK(std::fabs(norm(a) - kRoundRadius_m) < 1e-8);  // roundings of map coordinates
    CHECK(norm(0.5 * (a + b)) > kRoundRadius_m - WriteSettings{}.chord_error_m - 1e-8);
  }
}

TEST_CASE("geojson_writer__triangles_of_a_number_are_one_feature") {
  Model model;
  model.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 1}};
  model.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}};
  model.triangle_faces = {1, 0, 1};
  for (const bool by_part : {false, true}) {
    if (by_part) model.parts.resize(2);
    if (by_part) model.parts[1].name = "roof";
    const nlohmann::json file = geo_file(model);
    REQUIRE(file["features"].size() == 2);
    double areas[2] = {0, 0};
    for (const nlohmann::json& feature : file["features"]) {
      CHECK(feature["geometry"]["type"] == "MultiPolygon");
      for (const nlohmann::json& polygon : feature["geometry"]["coordinates"]) {
        REQUIRE(polygon.size() == 1);
        areas[feature["properties"]["face"].get<size_t>()] += plan_area_m2(polygon[0]);
      }
      CHECK(feature["properties"].contains("name") == by_part);
    }
    CHECK(areas[0] == 6);
    CHECK(areas[1] == 12);
    if (by_part) CHECK(file["features"][1]["properties"]["name"] == "roof");
  }
}

TEST_CASE("geojson_writer__names_a_metric_system_and_never_leaves_it_open_to_degrees") {
  CHECK(system_of("EPSG:2154") == "urn:ogc:def:crs:EPSG::2154");
  for (const char* unknown : {"", "the mayor's own", "EPSG:4326"})  // 4326: degrees
    CHECK(system_of(unknown).starts_with("LOCAL_CS["));
  const Folder folder;
  Task task;
  Model model;
  model.vertices = {{0, NAN, 0}};
  const Failure failure =
      failure_of([&] { write_geojson(model, folder.file("a.geojson"), {}, task); });
  CHECK(failure.status == Status::kInvalidArgument);
  CHECK(folder.entries() == 0);
}
