// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// What a facade made by hand asks to be dimensioned, and where it is drawn: inside the room that the margins keep.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "report/elevation/dimension_lines.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

// A wall of 12 x 9 m with three columns of windows, a door below the first, a cornice wider than the wall.
ElevationFaces dimensioned_facade() {
  ElevationFaces out = drawn::facade({drawn::wall({0, 0}, {12, 9})}, {-0.2, 0}, {12.2, 9});
  out.wall_low = {0, 0};
  out.wall_high = {12, 9};
  DrawnFace cornice = drawn::wall({-0.2, 8.4}, {12.2, 9}, -0.3);
  cornice.role = DrawnFace::Role::kElement;
  out.faces.push_back(cornice);
  drawn::add_type(out, "window", "W1");
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 2; ++row)
      out.openings.push_back(drawn::opening(0, {1.5 + 4.0 * column, 3.8 + 2.2 * row},
                                            {2.5 + 4.0 * column, 5.2 + 2.2 * row}));
  out.openings.push_back(drawn::opening(0, {1.2, 0}, {2.8, 2.4}));
  return out;
}

bool is_level_there(const Dimensions& d, double level) {
  return std::any_of(d.levels.begin(), d.levels.end(),
                     [&](double at) { return std::fabs(at - level) < 1e-9; });
}

// Would every chain find room for its numbers at this scale?
bool is_legible_at(const std::vector<double>& places, const Sheet& sheet) {
  DimensionLine line;
  for (size_t i = 0; i < places.size(); ++i) {
    line.at_mm.push_back(sheet.mm_of(places[i]));
    if (i > 0) line.values_m.push_back(places[i] - places[i - 1]);
  }
  return has_room(line);
}

}  // namespace

TEST_CASE("dimensions__span_the_walls_and_take_levels_from_long_elements_only") {
  ElevationFaces faces = dimensioned_facade();
  ElevationContent content;
  const Dimensions d = dimensions_of(faces, content);
  CHECK(d.columns.from == 0);  // the wall's ends, without the cornice's
  CHECK(d.columns.to == 12);
  CHECK(d.columns.openings.size() == 3);
  CHECK(d.ground_floor.openings.size() == 1);
  CHECK(is_level_there(d, 8.4));
  DrawnFace& cornice = faces.faces.back();
  cornice.rings = {drawn::box({0, 8.4}, {3, 9})};  // a quarter of the facade: a sign, no cornice
  CHECK(!is_level_there(dimensions_of(faces, content), 8.4));
  cornice.rings = {drawn::box({0, 8.4}, {8, 9})};
  CHECK(is_level_there(dimensions_of(faces, content), 8.4));
  cornice.kind = DrawnFace::Kind::kSlanted;  // a roof seen at an angle
  CHECK(!is_level_there(dimensions_of(faces, content), 8.4));
  content.dimensions = false;
  CHECK(dimensions_of(faces, content).levels.empty());
  content.dimensions = true;
  faces.empty = true;
  CHECK(dimensions_of(faces, content).levels.empty());
}

TEST_CASE("dimensions__are_drawn_within_the_margins_that_were_kept_for_them") {
  const ElevationFaces faces = dimensioned_facade();
  const ElevationContent content;
  const ElevationDrawing drawing = drawn::on_a3(faces, content);
  const std::string svg = drawn::svg_of([&](SvgWriter& out) { draw_dimensions(out, drawing); });
  CHECK(markup::well_formed(svg));
  const Sheet& sheet = drawing.sheet;
  size_t above = 0, right = 0, below = 0;
  for (const markup::TextBox& box : markup::text_boxes(svg)) {
    CAPTURE(box.text);
    CHECK(box.left >= sheet.frame.x);
    CHECK(box.top >= sheet.frame.y);
    CHECK(box.right <= sheet.legend.x);
    CHECK(box.bottom <= sheet.strip.y);
    const bool is_above = box.bottom <= sheet.view.y, is_right = box.left >= sheet.view.right(),
               is_below = box.top >= sheet.view.bottom();
    CHECK(is_above + is_right + is_below >= 1);  // none on the drawing
    above += is_above && !is_right;              // the mark of the top stands beside the drawing
    right += is_right;
    below += is_below;
  }
  // Above: 3 columns in 7 pieces, 4 between the axes, the whole. Below: the door in 3 pieces.
  CHECK(above == 7 + 4 + 1);
  CHECK(below == 3);
  CHECK(right > 5);
  CHECK(drawn::places(svg, "12.00").size() == 1);
  CHECK(drawn::places(svg, "9.00").size() == 1);
  // A facade without openings asks for less room on every side.
  const Margins_mm much = margins_for(drawing.dimensions), none = margins_for({});
  CHECK(much.above == none.above + 2 * kDimensionStep_mm);
  CHECK(much.right > none.right + kLevelMark_mm);
  CHECK(much.below > none.below);
}

TEST_CASE("dimensions__without_room_are_dropped_the_narrowest_first_until_all_can_be_read") {
  RandomStream random(3, 0);
  std::vector<OpeningBox> openings;
  for (int column = 0; column < 20; ++column) {
    const double u = 1 + 2.5 * column + 0.4 * random.uniform();
    openings.push_back({{u, 4}, {u + 0.4 + 1.2 * random.uniform(), 6}});
    openings.push_back({{u, 1}, {u + 0.4 + 1.2 * random.uniform(), 3}});
  }
  const Dimensions all = find_dimensions(openings, {}, {{0, 0}, {52, 8}}, 0, kTypeTolerance_m);
  size_t last = all.columns.openings.size() + 1;
  for (const int64_t denominator : {20, 100, 200, 500, 2000}) {
    CAPTURE(denominator);
    Sheet sheet;
    sheet.denominator = denominator;
    Dimensions d = all;
    drop_illegible(d, sheet);
    for (const OpeningChain* chain : {&d.columns, &d.ground_floor, &d.rows})
      CHECK(is_legible_at(chain->sides(), sheet));
    CHECK(is_legible_at(d.axes, sheet));
    // What is left is as wide as all that went.
    double narrowest = INFINITY;
    for (const OpeningInterval& i : d.columns.openings)
      narrowest = std::min(narrowest, i.to - i.from);
    size_t wider = 0;
    for (const OpeningInterval& i : all.columns.openings) wider += i.to - i.from >= narrowest;
    CHECK(wider == d.columns.openings.size());
    CHECK(d.columns.openings.size() <= last);
    last = d.columns.openings.size();
    if (denominator == 20) CHECK(last == all.columns.openings.size());
  }
  CHECK(last < all.columns.openings.size());
}
