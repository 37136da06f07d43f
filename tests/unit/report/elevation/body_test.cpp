// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Faces and openings made by hand, in the order and with the lines of what is drawn.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "geometry/polygon2.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

std::string body_of(const ElevationFaces& faces, const char* id = "") {
  ElevationContent content;
  content.id = id;
  const ElevationDrawing drawing = drawn::on_a3(faces, content);
  return drawn::svg_of([&](SvgWriter& svg) { draw_body(svg, drawing); });
}

// A point of the page back in the facade.
Vec2 in_facade(const ElevationFaces& faces, const Vec2& page) {
  const ElevationContent content;
  const OnPaper on_paper = drawn::on_a3(faces, content).on_paper;
  return {on_paper.low.u + (page.u - on_paper.origin_mm.u) / on_paper.mm_per_m,
          on_paper.low.v - (page.v - on_paper.origin_mm.v) / on_paper.mm_per_m};
}

}  // namespace

TEST_CASE("body__is_drawn_from_far_to_near_each_opening_after_its_own_wall") {
  RandomStream random(1, 0);
  for (int trial = 0; trial < 30; ++trial) {
    CAPTURE(trial);
    // Everything has its own width: its depth is found again by it.
    std::vector<DrawnFace> made;
    std::vector<double> depths;
    for (int i = 0; i < 8; ++i) {
      depths.push_back(static_cast<double>(random.below(5)));
      made.push_back(drawn::wall({0, 0}, {1 + 0.5 * i, 9}, depths.back()));
    }
    const auto by_depth = [](const auto& a, const auto& b) { return a.depth_m > b.depth_m; };
    std::stable_sort(made.begin(), made.end(), by_depth);
    ElevationFaces faces = drawn::facade(made, {0, 0}, {10, 9});
    drawn::add_type(faces, "window", "W1");
    for (int i = 0; i < 6; ++i) {
      depths.push_back(depths[random.below(8)]);
      faces.openings.push_back(drawn::opening(0, {0, 1}, {1 + 0.5 * (8 + i), 2}, depths.back()));
    }
    std::stable_sort(faces.openings.begin(), faces.openings.end(), by_depth);
    double last = INFINITY;
    bool last_is_opening = false;
    size_t drawn_things = 0;
    for (const markup::Tag& path : drawn::elements(body_of(faces), "path")) {
      const auto ring = drawn::corners(path.attribute("d"));
      const double width_m = (ring[1].u - ring[0].u) / 10;
      const double depth = depths[static_cast<size_t>(std::lround((width_m - 1) / 0.5))];
      const bool is_opening = path.attribute("class") == "opening";
      CHECK(depth <= last);
      if (depth == last) CHECK(is_opening >= last_is_opening);
      last = depth;
      last_is_opening = is_opening;
      ++drawn_things;
    }
    CHECK(drawn_things == 14);
  }
}

TEST_CASE("body__copies_are_dashed_and_planes_seen_edge_on_are_lines") {
  ElevationFaces faces = drawn::facade({drawn::wall({0, 0}, {8, 6})}, {0, 0}, {8, 6});
  DrawnFace edge = drawn::wall({2, 1}, {2, 5});
  edge.kind = DrawnFace::Kind::kEdgeOn;
  edge.role = DrawnFace::Role::kElement;
  edge.edge[0] = {2, 1};
  edge.edge[1] = {2, 5};
  DrawnFace ground = edge;
  ground.role = DrawnFace::Role::kGround;
  ground.edge[0] = {0, 0};
  ground.edge[1] = {8, 0};
  faces.faces.push_back(edge);
  faces.faces.push_back(ground);
  faces.faces[0].is_copy = true;
  drawn::add_type(faces, "window", "W1");
  drawn::add_type(faces, "window", "W1");
  faces.list.rows[1].evidence = Evidence::kCopied;
  faces.openings = {drawn::opening(0, {1, 1}, {2, 2}), drawn::opening(1, {4, 1}, {5, 2})};
  const std::string svg = body_of(faces);
  CHECK(markup::well_formed(svg));
  const auto lines = drawn::elements(svg, "line");
  REQUIRE(lines.size() == 2);
  CHECK(norm(in_facade(faces, {drawn::number(lines[0], "x2"), drawn::number(lines[0], "y2")}) -
             Vec2{2, 5}) < 1e-4);  // a thousandth of a millimetre of paper
  CHECK(norm(in_facade(faces, {drawn::number(lines[1], "x2"), drawn::number(lines[1], "y2")}) -
             Vec2{8, 0}) < 1e-4);
  CHECK(lines[0].attribute("stroke") == kEdgeOn);
  CHECK(drawn::number(lines[1], "stroke-width") > drawn::number(lines[0], "stroke-width"));
  const auto walls = drawn::elements(svg, "path", "class", "face"),
             openings = drawn::elements(svg, "path", "class", "opening");
  REQUIRE(walls.size() == 1);
  REQUIRE(openings.size() == 2);
  CHECK(walls[0].attribute("stroke-dasharray") != "none");
  CHECK(openings[0].attribute("stroke-dasharray") == "none");
  CHECK(openings[1].attribute("stroke-dasharray") != "none");
  // Paper shows between the dashes: a wider white line below, along the same contour.
  const auto white = drawn::elements(svg, "path", "stroke", "#ffffff");
  REQUIRE(white.size() == 1);
  CHECK(white[0].attribute("d") == openings[1].attribute("d"));
  CHECK(drawn::number(white[0], "stroke-width") > drawn::number(openings[1], "stroke-width"));
}

TEST_CASE("body__the_cross_of_an_empty_opening_ends_on_its_contour_also_under_an_arch") {
  ElevationFaces faces = drawn::facade({drawn::wall({0, 0}, {8, 6})}, {0, 0}, {8, 6});
  drawn::add_type(faces, "window", "W1");
  DrawnOpening arched = drawn::opening(0, {2, 1}, {4, 4});
  std::vector<Vec2>& contour = arched.contour[0].polygon;
  contour = {{2, 1}, {4, 1}, {4, 3}};
  for (int i = 1; i <= 32; ++i)  // half a circle of 1 m about (3, 3)
    contour.push_back({3 + std::cos(0.1 * i * 0.98), 3 + std::sin(0.1 * i * 0.98)});
  faces.openings = {arched};
  CHECK(drawn::elements(body_of(faces), "line").empty());
  faces.openings[0].is_empty = true;
  const auto lines = drawn::elements(body_of(faces), "line");
  REQUIRE(lines.size() == 2);
  const double step = norm(Vec2{2, 3}) / 2 / 64;  // places are tried along half the diagonal
  for (const markup::Tag& line : lines) {
    const Vec2 a = in_facade(faces, {drawn::number(line, "x1"), drawn::number(line, "y1")}),
               b = in_facade(faces, {drawn::number(line, "x2"), drawn::number(line, "y2")});
    for (const Vec2& end : {a, b}) CHECK(border_distance(contour, end) <= step + 1e-4);
    CHECK(segment_distance({3, 2.5}, a, b) < 1e-3);  // through the middle of the box
    CHECK(norm(b - a) > 2.5);
  }
}

TEST_CASE("body__places_without_data_are_hatched_with_the_pattern_of_this_drawing") {
  ElevationFaces faces = drawn::facade({drawn::wall({0, 0}, {8, 6})}, {0, 0}, {8, 6});
  DrawnFace shadow = drawn::wall({5, 1}, {6, 2});
  shadow.role = DrawnFace::Role::kNoData;
  faces.faces.push_back(shadow);
  faces.unknown = {drawn::box({1, 1}, {2, 3})};
  const std::string svg = body_of(faces, "-3");
  const auto hatched = drawn::elements(svg, "path", "fill", "url(#unknown-3)");
  REQUIRE(hatched.size() == 2);
  // What shows through a hole lies under the wall, the mark of a shadow on it.
  const auto paths = drawn::elements(svg, "path");
  CHECK(paths.front().attribute("d") == hatched[0].attribute("d"));
  CHECK(paths.back().attribute("d") == hatched[1].attribute("d"));
  const auto groups = drawn::elements(svg, "g");
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].attribute("clip-path") == "url(#window-3)");
  CHECK(groups[0].attribute("fill-rule") == "evenodd");
}
