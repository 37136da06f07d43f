// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/dimension_lines.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"

namespace jalon {

namespace {

constexpr double kDimensionLinesText = 2.5, kThin = 0.18;
constexpr double kAbove = 1.1, kBelow = 3.3;  // base lines of numbers on either side of the line
constexpr double kTick = 1, kEnd = 1.5;       // half a tick; how far the line runs on
constexpr double kClear = 0.6;                // between a number and its neighbours
constexpr double kLevelGap = 3.7;             // between two level marks: a line of text

struct Place {
  double middle_mm = 0;
  std::string text;
  bool is_below = false;
};

// Each number stands on its piece where it fits there; at the ends of the chain outside it; else on the other side of
// the line. False when one fits nowhere.
bool place_numbers(const DimensionLine& line, std::vector<Place>& out) {
  const size_t pieces = line.at_mm.size() < 2 ? 0 : line.at_mm.size() - 1;
  const double way =
      pieces > 0 && line.at_mm.front() > line.at_mm.back() ? -1 : 1;  // heights grow up the paper
  double below_end = -INFINITY;                                       // along the way
  for (size_t i = 0; i < pieces; ++i) {
    const double from = way * line.at_mm[i], to = way * line.at_mm[i + 1];
    Place place{(from + to) / 2, text_of(line.values_m[i], 2), false};
    const double width = text_width(place.text, kDimensionLinesText);
    if (width + kClear > to - from) {
      if (i == 0 && pieces > 1) {
        place.middle_mm = from - kEnd - width / 2;
      } else if (i + 1 == pieces && pieces > 1) {
        place.middle_mm = to + kEnd + width / 2;
      } else {
        place.is_below = true;
        if (place.middle_mm - width / 2 < below_end) return false;
        below_end = place.middle_mm + width / 2 + kClear;
      }
    }
    place.middle_mm *= way;
    out.push_back(std::move(place));
  }
  return true;
}

// The point (along, across) of a line: across grows away from the drawing's top left.
Vec2 turned(const DimensionLine& line, double along, double across) {
  return line.is_upright ? Vec2{across, along} : Vec2{along, across};
}

void draw_tick(SvgWriter& svg, const Vec2& at) {
  svg_line(svg, at + Vec2{-kTick, kTick}, at + Vec2{kTick, -kTick}, kInk, 0.35);
}

}  // namespace

bool has_room(const DimensionLine& line) {
  std::vector<Place> ignored;
  return place_numbers(line, ignored);
}

void draw_dimension_line(SvgWriter& svg, const DimensionLine& line) {
  if (line.at_mm.size() < 2) return;
  const auto [low, high] = std::minmax_element(line.at_mm.begin(), line.at_mm.end());
  svg_line(svg, turned(line, *low - kEnd, line.line_mm), turned(line, *high + kEnd, line.line_mm),
           kInk, kThin);
  const double beyond = line.line_mm > line.from_mm ? 1.5 : -1.5;
  for (const double at : line.at_mm) {
    svg_line(svg, turned(line, at, line.from_mm), turned(line, at, line.line_mm + beyond), kGrey,
             0.1);
    draw_tick(svg, turned(line, at, line.line_mm));
  }
  std::vector<Place> places;
  place_numbers(line, places);
  for (const Place& place : places)
    svg_text(svg, turned(line, place.middle_mm, line.line_mm + (place.is_below ? kBelow : -kAbove)),
             kDimensionLinesText, Anchor::kMiddle, place.text, false, line.is_upright);
}

void draw_level_marks(SvgWriter& svg, const LevelMarks& marks) {
  std::vector<double> taken;
  for (size_t i = 0; i < marks.at_mm.size(); ++i) {
    const double y = marks.at_mm[i], x = marks.x_mm;
    if (std::any_of(taken.begin(), taken.end(),
                    [&](double t) { return std::fabs(t - y) < kLevelGap; }))
      continue;
    taken.push_back(y);
    const std::string number = text_of(marks.values_m[i], 2);
    const bool is_zero = number == "0.00";
    svg_line(svg, {x, y}, {x + kLevelMark_mm - 1.5, y}, kInk, kThin);
    const std::vector<Vec2> triangle{{x + 1.6, y}, {x + 0.6, y - 1.7}, {x + 2.6, y - 1.7}};
    svg.leaf("path", {{"d", svg_polyline(triangle) + "Z"},
                      {"fill", is_zero ? kInk : "#ffffff"},
                      {"stroke", kInk},
                      {"stroke-width", kThin}});
    const std::string sign = is_zero ? "\xC2\xB1" : number.front() == '-' ? "" : "+";
    svg_text(svg, {x + 3.2, y - 0.7}, kDimensionLinesText, Anchor::kStart, sign + number);
  }
}

}  // namespace jalon
