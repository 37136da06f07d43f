// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Dimension lines and height marks read back from their SVG: numbers, places, and texts clear of each other.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/random.h"
#include "base/text_number.h"
#include "report/elevation/dimension_lines.h"
#include "unit/report/drawn.h"

using namespace jalon;

namespace {

// 1:100: the numbers are tenths of the millimetres.
DimensionLine line_at(const std::vector<double>& at_mm, bool is_upright = false) {
  DimensionLine out;
  out.at_mm = at_mm;
  for (size_t i = 1; i < at_mm.size(); ++i)
    out.values_m.push_back(std::fabs(at_mm[i] - at_mm[i - 1]) / 10);
  out.line_mm = 50;
  out.from_mm = 60;
  out.is_upright = is_upright;
  return out;
}

std::string drawn_line(const DimensionLine& line) {
  return drawn::svg_of([&](SvgWriter& svg) { draw_dimension_line(svg, line); });
}

std::string drawn_marks(const LevelMarks& marks) {
  return drawn::svg_of([&](SvgWriter& svg) { draw_level_marks(svg, marks); });
}

// Pairs of texts that meet.
size_t meeting_texts(const std::string& svg) {
  const auto boxes = markup::text_boxes(svg);
  size_t n = 0;
  for (size_t i = 0; i < boxes.size(); ++i)
    for (size_t k = 0; k < i; ++k) n += boxes[i].meets(boxes[k]);
  return n;
}

}  // namespace

TEST_CASE("dimension_lines__numbers_with_room_stand_on_the_middle_of_their_pieces") {
  for (const bool is_upright : {false, true}) {
    CAPTURE(is_upright);
    std::vector<double> at{100, 112, 130, 152};
    if (is_upright) std::reverse(at.begin(), at.end());  // heights grow up the paper
    const DimensionLine line = line_at(at, is_upright);
    CHECK(has_room(line));
    const std::string svg = drawn_line(line);
    const auto texts = drawn::elements(svg, "text");
    REQUIRE(texts.size() == 3);
    for (size_t i = 0; i < 3; ++i) {
      CHECK(texts[i].text_after == text_of(std::fabs(at[i + 1] - at[i]) / 10, 2));
      const double along = drawn::number(texts[i], is_upright ? "y" : "x"),
                   across = drawn::number(texts[i], is_upright ? "x" : "y");
      CHECK(std::fabs(along - (at[i] + at[i + 1]) / 2) <= drawn::kRounding_mm);
      CHECK(across < 50);  // on the side away from the reader's right hand
      CHECK(across > 50 - 2.5);
      CHECK((texts[i].attribute("transform").rfind("rotate(-90", 0) == 0) == is_upright);
    }
  }
}

TEST_CASE("dimension_lines__that_say_they_have_room_write_every_number_clear_of_the_others") {
  RandomStream random(1, 0);
  size_t roomy = 0, tight = 0;
  for (int trial = 0; trial < 400; ++trial) {
    CAPTURE(trial);
    std::vector<double> at{0};
    for (uint64_t n = 1 + random.below(7); n > 0; --n)
      at.push_back(at.back() + 1.5 + 12 * random.uniform());
    const bool is_upright = random.below(2) == 1;
    if (is_upright) std::reverse(at.begin(), at.end());
    const DimensionLine line = line_at(at, is_upright);
    if (!has_room(line)) {
      ++tight;
      continue;
    }
    ++roomy;
    const std::string svg = drawn_line(line);
    CHECK(markup::well_formed(svg));
    CHECK(drawn::elements(svg, "text").size() == line.values_m.size());
    CHECK(meeting_texts(svg) == 0);
    // The line, and at each place its extension and its tick.
    CHECK(drawn::elements(svg, "line").size() == 1 + 2 * at.size());
  }
  CHECK(roomy > 40);  // both occur
  CHECK(tight > 40);
}

TEST_CASE("dimension_lines__narrow_pieces_beside_each_other_have_no_room") {
  CHECK(has_room(line_at({})));
  CHECK(has_room(line_at({3})));
  CHECK(drawn_line(line_at({3})).empty());
  // Four characters of 1.5 mm want 6 mm: ends go outside, one below, two below side by side do not.
  CHECK(has_room(line_at({0, 2, 4})));
  CHECK(has_room(line_at({0, 2, 4, 6})));
  CHECK(!has_room(line_at({0, 2, 4, 6, 8})));
  CHECK(has_room(line_at({0, 2, 4, 14, 16, 18})));  // two below, 12 mm apart
}

TEST_CASE("dimension_lines__height_marks_carry_signs_and_the_most_wanted_come_first") {
  LevelMarks marks;
  marks.at_mm = {100, 60, 101, 80, 97, 110};
  marks.values_m = {0.001, 4, -0.1, 2, 0.3, -1};
  marks.x_mm = 200;
  const std::string svg = drawn_marks(marks);
  const auto texts = drawn::elements(svg, "text");
  REQUIRE(texts.size() == 4);  // what is 1 and 3 mm from the ground is left out
  const char* wanted[] = {("\xC2\xB1"
                           "0.00"),
                          "+4.00", "+2.00", "-1.00"};
  for (size_t i = 0; i < 4; ++i) CHECK(texts[i].text_after == wanted[i]);
  CHECK(meeting_texts(svg) == 0);
  for (const markup::Tag& line : drawn::elements(svg, "line"))
    CHECK(drawn::number(line, "x2") <= 200 + kLevelMark_mm);
  // Only the ground's triangle is full.
  CHECK(drawn::elements(svg, "path", "fill", "#ffffff").size() == 3);
  CHECK(drawn::elements(svg, "path", "fill", kInk).size() == 1);
}
