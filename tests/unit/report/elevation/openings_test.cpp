// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/opening_list.h"

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "report/elevation/dimension_chains.h"
#include "report/report.h"
#include "unit/modelling/walls.h"
#include "unit/report/markup.h"
#include "unit/report/named_facade.h"

using namespace jalon;

TEST_CASE("openings: types by class, form and size; standard deviations from corners and planes") {
  named_facade::Setting s;
  s.copied = 3;
  s.corner_variance = 4e-6;
  const OpeningList list = list_openings(named_facade::make(s), kTypeTolerance_m);
  REQUIRE(list.rows.size() == 15);
  REQUIRE(list.types.size() == 3);
  CHECK(list.types[0].tag == "W1");
  CHECK(list.types[0].count == 9);
  CHECK(list.types[0].copies == 1);
  CHECK(list.types[1].arched);
  CHECK(list.types[2].tag == "D1");
  CHECK(list.types[2].width_m == doctest::Approx(1.0));
  // Two sides of 2 mm each; the planes: 1 mm of offset each, and what the normals add at the place.
  CHECK(list.rows[0].sigma_width_m == doctest::Approx(std::sqrt(2.0) * 0.002));
  CHECK(list.rows[0].sigma_height_m == doctest::Approx(std::sqrt(2.0) * 0.002));
  CHECK(list.rows[0].sigma_depth_m > std::sqrt(2.0) * 0.001);
  CHECK(list.rows[0].sigma_depth_m < 2 * std::sqrt(2.0) * 0.001);
  CHECK(std::isnan(list_openings(named_facade::make({}), 0.05).rows[0].sigma_width_m));
  // The corners of a door's leaf are not measured, those of the notch that it closes are.
  Model m = named_facade::make(s);
  for (const Face& face : m.faces)
    for (uint64_t i = 0; face.id == 11 && i < m.rings[face.first_ring].count; ++i)
      m.vertex_covariances[m.corners[m.rings[face.first_ring].first + i]].fill(NAN);
  const OpeningRow door = list_openings(m, kTypeTolerance_m).rows.back();
  CHECK(door.part_class == part_class::kDoor);
  CHECK(door.sigma_width_m == doctest::Approx(std::sqrt(2.0) * 0.002));
}

TEST_CASE("openings: a model without names gives its holes, a person's size or larger") {
  walls::WallScan wall;
  wall.azimuth = 0;
  wall.spacing = 0.05;
  const walls::Rectangle window{2, 1, 3.2, 2.5};
  wall.solid = [=](double u, double v) { return !window.contains(u, v); };
  const Model m = walls::outlines_of(walls::segmentation_of({wall.points()}));
  const OpeningList list = list_openings(m, kTypeTolerance_m);
  REQUIRE(list.rows.size() == 1);
  CHECK(list.rows[0].part == kNoPart);
  CHECK(list.rows[0].width_m == doctest::Approx(1.2).epsilon(0.03).scale(0));
}

TEST_CASE(
    "dimensions: what repeats is written once, at its mean; what overlaps less often is left out") {
  std::vector<OpeningBox> boxes;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 3; ++column) {
      const double u = 1 + 3 * column + 0.01 * (row % 2), v = 1 + 3 * row;
      boxes.push_back({{u, v}, {u + 1.2, v + 1.5}});
    }
  boxes.push_back({{1.3, 4.2}, {2.9, 4.9}});  // overlaps the first column
  const Dimensions d = find_dimensions(boxes, {}, {{0, 0}, {10, 13}}, 0, 0.05);
  REQUIRE(d.columns.sides().size() == 8);
  CHECK(d.columns.sides()[1] == doctest::Approx(1.0067).epsilon(1e-3).scale(0));
  REQUIRE(d.axes.size() == 5);
  REQUIRE(d.rows.sides().size() == 10);
  CHECK(d.ground_floor.sides().empty());  // the same columns
  CHECK(d.levels.front() == 0);
  const Dimensions none = find_dimensions({}, {}, {{0, 0}, {10, 13}}, -0.5, 0.05);
  CHECK(none.columns.sides().empty());
  CHECK(none.levels == std::vector<double>{-0.5, 13, 0});
}

TEST_CASE("reports: openings with their precision, parts and evidence, as a page and as JSON") {
  named_facade::Setting s;
  s.copied = 3;
  s.corner_variance = 4e-6;
  const Model m = named_facade::make(s);
  walls::WallScan wall;
  wall.width = 3;
  wall.height = 2;
  const Segmentation segmentation = walls::segmentation_of({wall.points()});
  Task task;
  const std::string html = report_html(segmentation, m, "", {}, task);
  CHECK(markup::well_formed(html));
  for (const char* text :
       {">Openings<", ">Precision<", ">Parts<", "copy of window 1", "seen behind", ">2.83<",
        "14 windows, 1 door and 0 other openings.", "of the normal (mrad)", "And 14 reveals"})
    CHECK_MESSAGE(html.find(text) != std::string::npos, text);
  const auto json = nlohmann::json::parse(report_json(segmentation, m, "", task));
  REQUIRE(json["openings"].size() == 15);
  CHECK(json["openings"][3]["copied_from"] == 4);
  CHECK(json["openings"][0]["sigma_width_m"] == doctest::Approx(0.0028284).epsilon(1e-3).scale(0));
  CHECK(json["openings"][0]["copied_from"].is_null());
  CHECK(json["opening_types"][0]["count"] == 9);
  REQUIRE(json["parts"].size() == m.parts.size());
  CHECK(json["parts"][1]["parent"] == 0);
  CHECK(json["parts"][0]["parent"].is_null());
  const double sigma = json["planes"][0]["sigma_offset_m"];
  const auto& fit = segmentation.segments[0].fit;
  CHECK(sigma ==
        doctest::Approx(fit.sigma / std::sqrt(static_cast<double>(fit.n))).epsilon(0.01).scale(0));
}

TEST_CASE("reports: what the scanner makes of the planes, when it is told and stations are known") {
  walls::WallScan wall;
  wall.width = wall.height = 4;
  Segmentation segmentation = walls::segmentation_of({wall.points()});
  const char* notes =
      R"({"scanner": {"sigma_range_m": 0.004, "sigma_horizontal_rad": 0, "sigma_vertical_rad": 0}})";
  Task task;
  CHECK_THROWS_AS(report_json(segmentation, {}, notes, task), Error);  // no station
  CHECK_THROWS_AS(report_json(segmentation, {}, R"({"scanner": 3})", task), Error);
  Cloud cloud = *segmentation.cloud;
  Station station;
  station.has_pose = true;
  station.pose.m = {1, 0, 0, 2, 0, 1, 0, -30, 0, 0, 1, 2};
  station.count = cloud.size();
  cloud.stations.push_back(station);
  segmentation.cloud = std::make_shared<const Cloud>(cloud);
  const auto json = nlohmann::json::parse(report_json(segmentation, {}, notes, task));
  const auto& plane = json["planes"][0];
  CHECK(plane["sigma_scanner_m"].get<double>() >
        0.0035);  // a little less where the ray is not square to the wall
  CHECK(plane["sigma_scanner_m"].get<double>() < 0.004);
  CHECK(plane["variance_factor"].get<double>() > 0.9);
  CHECK(plane["variance_factor"].get<double>() < 1.3);
  CHECK(json["scanner"]["sigma_range_m"] == 0.004);
  const std::string html = report_html(segmentation, {}, notes, {}, task);
  CHECK(markup::well_formed(html));
  for (const char* text : {"variance factor", "sigma_range_m", "by the scanner (mm)"})
    CHECK_MESSAGE(html.find(text) != std::string::npos, text);
}
