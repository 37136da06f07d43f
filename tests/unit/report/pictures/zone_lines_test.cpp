// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <string>

#include "report/pictures/zone_lines.h"
#include "unit/compare/landslide/slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("zone_lines__draw_both_outlines_and_hatch_what_was_not_measured") {
  const auto gap = [](double x, double y) { return x > 30 && x < 36 && y > 10 && y < 20; };
  const Comparison made =
      compared_slopes(slope_survey(false, 1), slope_survey(true, 2, 60000, gap));
  SvgWriter svg;
  svg.open("svg", {});
  draw_zone_lines(svg, made, [](const Vec3& p) { return Vec2{4 * p.x, -4 * p.y}; });
  draw_zone_key(svg, 0, 0);
  const std::string text = svg.take();
  CHECK(text.find("#08306b") != std::string::npos);
  CHECK(text.find("#7f0000") != std::string::npos);
  // A line of the hatching in the gap: between x = 120 and 144 mm.
  size_t strokes = 0;
  for (size_t at = text.find('M'); at != std::string::npos; at = text.find('M', at + 1)) ++strokes;
  CHECK(strokes > 10);
  CHECK(text.find("not measured") != std::string::npos);
}
