// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Labels of scenes made by hand: where there is room, on what they name, clear of each other, never on what is hidden.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

std::string labels_of(const ElevationFaces& faces,
                      ElevationColours colours = ElevationColours::kSides) {
  ElevationContent content;
  content.colours = colours;
  const ElevationDrawing drawing = drawn::on_a3(faces, content);
  return drawn::svg_of([&](SvgWriter& svg) { draw_labels(svg, drawing); });
}

// The upright box of the drawing's texts lies in that of the page between two corners of the facade.
bool lies_within(const markup::TextBox& text, const ElevationFaces& faces, const Vec2& low,
                 const Vec2& high) {
  const ElevationContent content;
  const OnPaper on_paper = drawn::on_a3(faces, content).on_paper;
  const Vec2 a = on_paper(low), b = on_paper(high);
  return text.left >= a.u && text.right <= b.u && text.top >= b.v && text.bottom <= a.v;
}

// A wall of 20 x 10 m and openings of 2 m height with these widths, every 2.5 m.
ElevationFaces openings_of_width(const std::vector<double>& widths) {
  ElevationFaces out = drawn::facade({drawn::wall({0, 0}, {20, 10})}, {0, 0}, {20, 10});
  drawn::add_type(out, "window", "W1");
  for (size_t i = 0; i < widths.size(); ++i) {
    const double u = 1 + 2.5 * static_cast<double>(i);
    out.openings.push_back(drawn::opening(0, {u, 3}, {u + widths[i], 5}));
  }
  return out;
}

}  // namespace

TEST_CASE(
    "labels__types_stand_in_their_openings_smaller_where_it_is_tight_and_not_where_none_fits") {
  // Two characters want 3 mm and some air at 2.5 mm letters, less at 1.8 mm; 1 m is 10 mm.
  const ElevationFaces faces = openings_of_width({1.2, 0.36, 0.2});
  const std::string svg = labels_of(faces);
  const auto texts = drawn::elements(svg, "text");
  const auto boxes = markup::text_boxes(svg);
  REQUIRE(texts.size() == 2);
  CHECK(texts[0].text_after == "W1");
  CHECK(drawn::number(texts[1], "font-size") < drawn::number(texts[0], "font-size"));
  for (size_t i = 0; i < 2; ++i) {
    const DrawnOpening& opening = faces.openings[i];
    CHECK(lies_within(boxes[i], faces, opening.low, opening.high));
  }
  CHECK(drawn::elements(svg, "rect").size() == 2);  // a white field each
}

TEST_CASE("labels__of_hidden_openings_are_left_out_but_not_those_seen_through_a_hole") {
  ElevationFaces faces = openings_of_width({1.2, 1.2, 1.2});
  DrawnFace front = drawn::wall({0.5, 2}, {5.5, 6}, -0.3);    // before the first two
  front.rings.push_back(drawn::box({3.4, 2.9}, {4.8, 5.1}));  // a hole at the second
  faces.faces.push_back(front);
  const auto texts = drawn::elements(labels_of(faces), "text");
  REQUIRE(texts.size() == 2);
  const ElevationContent content;
  const OnPaper on_paper = drawn::on_a3(faces, content).on_paper;
  for (size_t i = 0; i < 2; ++i) {
    const DrawnOpening& opening = faces.openings[i + 1];
    const double middle = on_paper((opening.low + opening.high) * 0.5).u;
    CHECK(std::fabs(drawn::number(texts[i], "x") - middle) <= drawn::kRounding_mm);
  }
}

TEST_CASE("labels__never_meet_each_other") {
  RandomStream random(3, 0);
  for (const bool named : {true, false}) {
    CAPTURE(named);
    ElevationFaces faces = drawn::facade({}, {0, 0}, {20, 10});
    drawn::add_type(faces, "window", "W12");
    faces.has_named_openings = named;
    for (int i = 0; i < 150; ++i) {
      const Vec2 low{17 * random.uniform(), 8 * random.uniform()},
          high = low + Vec2{0.3 + 2.5 * random.uniform(), 0.3 + 1.5 * random.uniform()};
      if (named) faces.openings.push_back(drawn::opening(0, low, high));
      else faces.faces.push_back(drawn::wall(low, high));
      if (!named) faces.faces.back().label = static_cast<uint32_t>(i);
    }
    const auto boxes = markup::text_boxes(labels_of(faces));
    CHECK(boxes.size() > 20);
    CHECK(boxes.size() < 150);
    for (size_t i = 0; i < boxes.size(); ++i)
      for (size_t k = 0; k < i; ++k) CHECK(!boxes[i].meets(boxes[k]));
  }
}

TEST_CASE("labels__numbers_stand_on_their_own_plane_off_its_holes_in_letters_that_can_be_read") {
  ElevationFaces faces = drawn::facade({}, {0, 0}, {20, 10});
  DrawnFace frame = drawn::wall({0, 0}, {10, 10}, 0.5);
  frame.rings.push_back(drawn::box({1, 3}, {9, 9}));  // most room is below the hole
  frame.label = 7;
  DrawnFace slanted = drawn::wall({12, 0}, {18, 10});
  slanted.kind = DrawnFace::Kind::kSlanted;
  slanted.label = 8;
  DrawnFace sliver = drawn::wall({19, 0}, {19.2, 10});
  sliver.label = 9;
  faces.faces = {frame, slanted, sliver};
  const auto boxes = markup::text_boxes(labels_of(faces));
  REQUIRE(boxes.size() == 1);
  CHECK(boxes[0].text == "7");
  CHECK(lies_within(boxes[0], faces, {0, 0}, {10, 3}));
  // The farthest of eight depths is nearly black.
  faces.groups.assign(kMaxDepthGroups, {});
  const auto fill = [&] {
    return drawn::elements(labels_of(faces, ElevationColours::kDepth), "text")
        .at(0)
        .attribute("fill");
  };
  CHECK(fill() == kInk);
  faces.faces[0].group = kMaxDepthGroups - 1;
  CHECK(fill() == "#ffffff");
}
