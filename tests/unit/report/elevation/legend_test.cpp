// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Lines of the legend against what occurs on drawings made by hand, and their room on the sheet.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "report/elevation/legend.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

using Sign = LegendItem::Sign;

ElevationFaces legend_facade() {
  ElevationFaces out = drawn::facade({drawn::wall({0, 0}, {8, 6})}, {0, 0}, {8, 6});
  drawn::add_type(out, "window", "W1");
  drawn::add_type(out, "window", "W2");
  drawn::add_type(out, "door", "D1");
  out.openings = {drawn::opening(0, {1, 1}, {2, 2})};
  return out;
}

size_t lines_with(const std::vector<LegendItem>& items, const std::string& text) {
  return static_cast<size_t>(std::count_if(
      items.begin(), items.end(), [&](const LegendItem& item) { return item.text == text; }));
}

Sheet sheet_with_legend(double height) {
  Sheet out;
  out.legend = {100, 20, 50, height};
  return out;
}

std::string drawn_legend(const std::vector<LegendItem>& items, const Sheet& sheet) {
  return drawn::svg_of([&](SvgWriter& svg) { draw_legend(svg, items, sheet); });
}

}  // namespace

TEST_CASE("legend__a_sign_has_a_line_exactly_when_it_occurs") {
  using Change = std::function<void(ElevationFaces&)>;
  const auto turn = [](DrawnFace::Kind kind, DrawnFace::Role role) {
    return [=](ElevationFaces& f) {
      f.faces.push_back(drawn::wall({1, 1}, {2, 2}));
      f.faces.back().kind = kind;
      f.faces.back().role = role;
    };
  };
  using Kind = DrawnFace::Kind;
  using Role = DrawnFace::Role;
  const std::pair<const char*, Change> changes[] = {
      {"door",
       [](ElevationFaces& f) {
         f.openings.push_back(drawn::opening(2, {4, 0}, {5, 2}));
       }},
      {"other opening",
       [](ElevationFaces& f) {
         drawn::add_type(f, "opening", "O1");
         f.openings.push_back(drawn::opening(3, {4, 0}, {5, 2}));
       }},
      {"copied: not measured here", [](ElevationFaces& f) { f.faces[0].is_copy = true; }},
      {"copied: not measured here", [](ElevationFaces& f) { f.list.rows[0].copied_from = 1; }},
      {"nothing seen in it", [](ElevationFaces& f) { f.openings[0].is_empty = true; }},
      {"plane seen edge-on", turn(Kind::kEdgeOn, Role::kElement)},
      {"ground", turn(Kind::kEdgeOn, Role::kGround)},
      {"plane seen at an angle", turn(Kind::kSlanted, Role::kElement)},
      {"no data", turn(Kind::kFront, Role::kNoData)},
      {"no data", [](ElevationFaces& f) {
         f.unknown = {drawn::box({1, 1}, {2, 2})};
       }}};
  const auto plain = legend_items(legend_facade(), {});
  CHECK(lines_with(plain, "window") == 1);
  for (const auto& named : changes) {
    const auto& text = named.first;
    CHECK_MESSAGE(lines_with(plain, text) == 0, text);
    ElevationFaces faces = legend_facade();
    named.second(faces);
    CHECK_MESSAGE(lines_with(legend_items(faces, {}), text) == 1, text);
  }
  ElevationFaces empty = legend_facade();
  empty.empty = true;
  CHECK(legend_items(empty, {}).empty());
}

TEST_CASE("legend__types_are_counted_as_they_are_drawn_and_depths_carry_signs") {
  ElevationFaces faces = legend_facade();
  faces.openings.push_back(drawn::opening(2, {4, 0}, {5, 2}));
  faces.list.rows.push_back(faces.list.rows[0]);  // another window of the first type
  faces.openings.push_back(drawn::opening(3, {6, 1}, {7, 2}));
  faces.list.types[0].width_m = 1.204;
  faces.list.types[0].height_m = 1.5;
  faces.list.types[0].arched = true;
  faces.list.types[0].count = 99;  // on all sides of the building
  faces.groups = {{-0.31, -0.3, 2, -1, 0}, {-0.001, 0.001, 5, 0, 0}, {0.15, 0.15, 1, 1, 0}};
  const auto items = legend_items(faces, {});
  std::vector<LegendItem> types;
  for (const LegendItem& item : items)
    if (item.sign == Sign::kType) types.push_back(item);
  REQUIRE(types.size() == 2);  // no W2 on this drawing
  CHECK(types[0].tag == "W1");
  CHECK(types[0].count == "2");
  CHECK(types[0].text == "1.20 x 1.50 arch");
  CHECK(types[1].tag == "D1");
  CHECK(types[1].count == "1");
  for (const char* text : {"-0.31 to -0.30 (2)", "0.00 (5)", "+0.15"})
    CHECK(lines_with(items, text) == 1);
  ElevationContent plain;
  plain.colours = ElevationColours::kNone;  // nothing is filled: no depths
  CHECK(lines_with(legend_items(faces, plain), "+0.15") == 0);
  faces.has_named_openings = false;
  for (const LegendItem& item : legend_items(faces, {})) CHECK(item.sign != Sign::kType);
}

TEST_CASE("legend__lines_stay_in_their_column_and_what_has_no_room_is_counted") {
  std::vector<LegendItem> items;
  for (int i = 0; i < 12; ++i)
    items.push_back({Sign::kSwatch, "#ffffff", "line " + std::to_string(i), "", ""});
  size_t last = 0;
  for (double height = 15; height < 75; height += 0.7) {
    CAPTURE(height);
    const Sheet sheet = sheet_with_legend(height);
    const std::string svg = drawn_legend(items, sheet);
    size_t shown = 0, left = 0;
    for (const markup::TextBox& box : markup::text_boxes(svg)) {
      CHECK(box.top >= sheet.legend.y);
      CHECK(box.bottom <= sheet.legend.bottom());
      CHECK(box.left >= sheet.legend.x);
      CHECK(box.right <= sheet.legend.right());
      if (box.text.rfind("and ", 0) == 0) left = std::stoul(box.text.substr(4));
      else ++shown;
    }
    CHECK(shown + left == items.size());
    CHECK(left != 1);  // its own line has that room
    CHECK(shown >= last);
    last = shown;
    for (const markup::Tag& swatch : drawn::elements(svg, "rect"))
      CHECK(drawn::number(swatch, "y") + drawn::number(swatch, "height") <= sheet.legend.bottom());
  }
  CHECK(last == items.size());
}

TEST_CASE("legend__the_height_that_it_asks_for_holds_all_lines") {
  ElevationFaces faces = legend_facade();
  for (const size_t groups : {0u, 1u, 8u}) {
    faces.groups.assign(groups, {0.1, 0.2, 1, 1, 0});
    const auto items = legend_items(faces, {});
    const std::string svg = drawn_legend(items, sheet_with_legend(legend_height(items)));
    CHECK(svg.find("more lines") == std::string::npos);
    CHECK(drawn::places(svg, "W1").size() == 1);
  }
}
