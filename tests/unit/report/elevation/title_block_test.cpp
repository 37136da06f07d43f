// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Scale bars measured with their own labels; the plan of the view against a compass; what the title block tells.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "report/elevation/title_block.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

std::string title_block_of(const ElevationContent& content, double ground_m = 0) {
  ElevationFaces faces = drawn::facade({drawn::wall({0, 0}, {8, 6})}, {0, 0}, {8, 6});
  faces.ground_m = ground_m;
  const ElevationDrawing drawing = drawn::on_a3(faces, content);
  return drawn::svg_of([&](SvgWriter& svg) { draw_title_block(svg, drawing); });
}

bool tells(const std::string& svg, const std::string& text) {
  return !drawn::places(svg, text).empty();
}

}  // namespace

TEST_CASE("title_block__the_scale_bar_is_as_long_as_its_labels_say_at_every_scale") {
  for (const int64_t denominator : {1, 2, 10, 20, 25, 50, 100, 200, 250, 500, 1000, 25000}) {
    CAPTURE(denominator);
    const Sheet sheet = lay_out_sheet(0.0001, 0.0001, "A3", denominator);
    const std::string svg = drawn::svg_of([&](SvgWriter& out) { draw_scale_bar(out, sheet); });
    std::vector<double> values, places;
    for (const markup::Tag& text : drawn::elements(svg, "text")) {
      double value = 0;
      if (!parse_number(text.text_after, value)) continue;
      values.push_back(value);
      places.push_back(drawn::number(text, "x"));
    }
    const auto fields = drawn::elements(svg, "rect");
    REQUIRE(values.size() == fields.size() + 1);
    REQUIRE(values.size() >= 3);
    CHECK(values[0] == 0);
    for (size_t i = 0; i < values.size(); ++i)
      CHECK(std::fabs((places[i] - places[0]) - sheet.mm_of(values[i])) <= 2 * drawn::kRounding_mm);
    for (size_t i = 0; i < fields.size(); ++i) {
      CHECK(std::fabs(drawn::number(fields[i], "x") - places[i]) <= 2 * drawn::kRounding_mm);
      if (i > 0) CHECK(fields[i].attribute("fill") != fields[i - 1].attribute("fill"));
    }
    // About 60 mm: two fields of 30 mm at most, and five of 12 mm.
    CHECK(places.back() - places[0] <= 66);
    CHECK(places.back() - places[0] >= 40);
    CHECK(tells(svg, "Scale 1:" + std::to_string(denominator)));
  }
}

TEST_CASE("title_block__the_plan_of_the_view_points_as_the_compass_does") {
  for (int degrees = -180; degrees <= 180; degrees += 15) {
    CAPTURE(degrees);
    ElevationContent content;
    content.view_azimuth_rad = degrees * std::numbers::pi / 180;
    const std::string svg = title_block_of(content);
    const auto looks = drawn::elements(svg, "line", "stroke", "#b3472f");
    REQUIRE(looks.size() == 1);
    // North up the page, east to the right: the azimuth is the turn from up, clockwise.
    const double dx = drawn::number(looks[0], "x2") - drawn::number(looks[0], "x1"),
                 dy = drawn::number(looks[0], "y2") - drawn::number(looks[0], "y1");
    const double turn = std::atan2(dx, -dy) - content.view_azimuth_rad;
    CHECK(std::fabs(std::remainder(turn, 2 * std::numbers::pi)) < 1e-3);  // 7 mm to 0.001 mm
    // The facade stands across it.
    const auto facade = drawn::elements(svg, "line", "stroke-width", "0.7");
    REQUIRE(facade.size() == 1);
    const double fx = drawn::number(facade[0], "x2") - drawn::number(facade[0], "x1"),
                 fy = drawn::number(facade[0], "y2") - drawn::number(facade[0], "y1");
    CHECK(std::fabs(dx * fx + dy * fy) < 1e-3 * std::hypot(dx, dy) * std::hypot(fx, fy));
    CHECK(tells(svg, std::to_string((degrees + 360) % 360) + ".0\xC2\xB0"));
  }
  ElevationContent content;
  content.view_azimuth_rad = -1e-9;  // a hair to the left of north
  CHECK(tells(title_block_of(content), "0.0\xC2\xB0"));
  CHECK(tells(title_block_of(content), "+Y"));
  content.has_north = true;
  CHECK(tells(title_block_of(content), "N"));
  CHECK(tells(title_block_of(content), "Direction of view from north"));
}

TEST_CASE("title_block__cells_fill_their_row_and_what_is_not_told_has_none") {
  ElevationContent content;
  content.points = 1234567;
  content.planes = 12;
  const std::string plain = title_block_of(content, 137.256);
  CHECK(tells(plain, "1 234 567 points, 12 planes"));
  CHECK(tells(plain,
              "\xC2\xB1"
              "0.00 = Z 137.26"));
  CHECK(tells(plain, "1:100  (A3)"));
  CHECK(!tells(plain, "Date"));
  CHECK(!tells(plain, "Source"));
  content.date = "2026-03-01";
  content.source = "a.las";
  const std::string full = title_block_of(content);
  CHECK(tells(full, "Date"));
  CHECK(tells(full, "2026-03-01"));
  CHECK(tells(full, "a.las"));
  for (const std::string* svg : {&plain, &full}) {
    double rows[3] = {}, y[3] = {};
    size_t row = 0;
    for (const markup::Tag& cell : drawn::elements(*svg, "rect")) {
      if (rows[row] > 0 && std::fabs(drawn::number(cell, "y") - y[row]) > 1) ++row;
      REQUIRE(row < 3);
      y[row] = drawn::number(cell, "y");
      rows[row] += drawn::number(cell, "width");
    }
    CHECK(row == 2);
    // Four cells of a row, each rounded.
    for (const double width : rows) CHECK(std::fabs(width - rows[0]) <= 8 * drawn::kRounding_mm);
  }
}

TEST_CASE("title_block__long_and_hostile_titles_stay_text_inside_their_cell") {
  ElevationContent content;
  for (const std::string& title :
       {std::string(300, 'W'), std::string("</text><script>alert(1)</script>"),
        std::string(200, '&')}) {
    content.title = title;
    const std::string svg = title_block_of(content);
    CHECK(markup::well_formed(svg));
    CHECK(drawn::elements(svg, "script").empty());
    const auto cells = drawn::elements(svg, "rect");
    bool found = false;
    for (const markup::Tag& text : drawn::elements(svg, "text")) {
      if (text.attribute("font-size") != "4.2") continue;
      found = true;
      if (title[0] != 'W') continue;  // references are one letter each
      const double width = 0.6 * 4.2 * static_cast<double>(text.text_after.size());
      CHECK(drawn::number(text, "x") + width <=
            drawn::number(cells[0], "x") + drawn::number(cells[0], "width"));
      CHECK(text.text_after.size() > 20);
      CHECK(text.text_after.substr(text.text_after.size() - 3) == "...");
    }
    CHECK(found);
  }
}
