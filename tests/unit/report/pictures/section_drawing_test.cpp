// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/section_drawing.h"

#include <doctest/doctest.h>

#include <regex>

using namespace jalon;

namespace {

// A rectangle of 6 x 3 m in each of so many sections.
Sections rectangles(SectionKind kind, size_t n) {
  Sections sections;
  sections.kind = kind;
  for (size_t s = 0; s < n; ++s) {
    Section section;
    section.plane = {static_cast<double>(s), {652000, 6861000, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    SectionLine line;
    line.vertices = {{0, 0}, {6, 0}, {6, 3}, {0, 3}};
    line.is_closed = true;
    section.lines.push_back(line);
    sections.sections.push_back(section);
  }
  return sections;
}

size_t count(const std::string& text, const std::string& what) {
  size_t n = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

// Width in millimetres of the first path on the paper.
double width_of_first_path(const std::string& svg) {
  std::smatch match;
  REQUIRE(std::regex_search(svg, match, std::regex("d=\"M([0-9.]+) [0-9.]+L([0-9.]+) ")));
  return std::stod(match[2]) - std::stod(match[1]);
}

}  // namespace

TEST_CASE("section_drawing__level_sections_are_one_plan_with_a_key_and_true_coordinates") {
  const std::string svg = section_drawing(rectangles(SectionKind::kHeight, 3));
  CHECK(count(svg, "<path") == 3);
  CHECK(count(svg, ">Z 2.000<") == 1);
  CHECK(count(svg, ">652002<") == 1);
  REQUIRE(count(svg, "scale 1 : 50<") == 1);
  CHECK(width_of_first_path(svg) == doctest::Approx(120));  // 6 m at 1 : 50
}

TEST_CASE("section_drawing__many_level_sections_say_how_many_the_key_leaves_out") {
  const std::string svg = section_drawing(rectangles(SectionKind::kHeight, 100));
  CHECK(count(svg, "<path") == 100);
  CHECK(count(svg, "and 61 more") == 1);
}

TEST_CASE("section_drawing__sections_of_an_alignment_stand_side_by_side_at_one_scale") {
  const std::string svg = section_drawing(rectangles(SectionKind::kAlignment, 5));
  CHECK(count(svg, "<path") == 5);
  CHECK(count(svg, ">STATION 4.000<") == 1);
  CHECK(count(svg, ">offset (m)<") == 5);
  REQUIRE(count(svg, "scale 1 : 100<") == 1);
  CHECK(width_of_first_path(svg) == doctest::Approx(60));
}

TEST_CASE("section_drawing__of_nothing_is_an_empty_sheet") {
  CHECK(count(section_drawing({}), "<path") == 0);
  Sections none = rectangles(SectionKind::kAlignment, 2);
  for (Section& section : none.sections) section.lines.clear();
  CHECK(count(section_drawing(none), "<path") == 0);
}
