// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/sheet/sheet.h"

#include <algorithm>
#include <string_view>

namespace jalon {

namespace {

constexpr double kMargin = 8, kStrip = 30, kLegend = 50;
constexpr double kFigureWidth = 170;

struct Paper {
  std::string_view size;
  const char* name;
  double width, height;  // mm (ISO 216)
};
// Small before large, landscape before upright. An upright A4 has no room for the title block.
constexpr Paper kPapers[] = {
    {"A4", "A4", 297, 210},         {"A3", "A3", 420, 297},         {"A3", "A3 upright", 297, 420},
    {"A2", "A2", 594, 420},         {"A2", "A2 upright", 420, 594}, {"A1", "A1", 841, 594},
    {"A1", "A1 upright", 594, 841}, {"A0", "A0", 1189, 841},        {"A0", "A0 upright", 841, 1189},
};
constexpr std::string_view kOfficePaper = "A3";  // the largest that an office printer takes

// Usual scales (ISO 5455 and the surveyor's 1:25 and 1:250), decade by decade.
int64_t usual_scale(int i) {
  constexpr int64_t kFactors[] = {100, 200, 250, 500};
  int64_t scale = kFactors[i % 4];
  for (int k = 0; k < i / 4; ++k) scale *= 10;
  return scale / 100;  // 1, 2, 2 (2.5), 5, 10, 20, 25, 50, ...
}
constexpr int kScales = 4 * 10;

Box_mm free_box(double width, double height, const Margins_mm& m) {
  const double left = kMargin + m.left, top = kMargin + m.above;
  return {left, top, width - left - m.right - kLegend - kMargin,
          height - top - m.below - kStrip - kMargin};
}

// What the drawing asks of a sheet.
struct Need {
  double width_m, height_m;
  Margins_mm margins;
};

bool fits(const Paper& paper, const Need& need, int64_t denominator) {
  const Box_mm box = free_box(paper.width, paper.height, need.margins);
  const double mm = 1000 / static_cast<double>(denominator);
  return need.width_m * mm <= box.width && need.height_m * mm <= box.height;
}

int64_t largest_scale(const Paper& paper, const Need& need) {
  for (int i = 0; i < kScales; ++i)
    if (fits(paper, need, usual_scale(i))) return usual_scale(i);
  return usual_scale(kScales - 1);
}

Sheet place(double width, double height, const std::string& name, int64_t denominator,
            const Need& need) {
  Sheet s;
  s.paper = name;
  s.denominator = denominator;
  s.width = width;
  s.height = height;
  s.frame = {kMargin, kMargin, width - 2 * kMargin, height - 2 * kMargin};
  const Box_mm room = free_box(width, height, need.margins);
  s.view = {0, 0, s.mm_of(need.width_m), s.mm_of(need.height_m)};
  s.view.x = room.x + std::max(0.0, (room.width - s.view.width) / 2);
  s.view.y = room.y + std::max(0.0, (room.height - s.view.height) / 2);
  s.legend = {s.frame.right() - kLegend, s.frame.y, kLegend, s.frame.height - kStrip};
  s.strip = {s.frame.x, s.frame.bottom() - kStrip, s.frame.width, kStrip};
  return s;
}

}  // namespace

Sheet lay_out_sheet(double width_m, double height_m, const std::string& paper, int64_t denominator,
                    const Margins_mm& margins) {
  const Need need{width_m, height_m, margins};
  const bool is_auto = paper == "auto";
  if (denominator == 0)
    for (const Paper& p : kPapers)
      if (p.size == (is_auto ? kOfficePaper : std::string_view(paper))) {
        const int64_t scale = largest_scale(p, need);
        denominator = denominator == 0 ? scale : std::min(denominator, scale);
      }
  const Paper* largest = &kPapers[0];  // landscape
  for (const Paper& p : kPapers) {
    if (!is_auto && p.size != paper) continue;
    if (fits(p, need, denominator)) return place(p.width, p.height, p.name, denominator, need);
    if (p.width > p.height) largest = &p;
  }
  // No such paper: one of its own size (a roll), so that the scale asked for holds.
  const double mm = 1000 / static_cast<double>(denominator);
  const Box_mm none = free_box(0, 0, margins);
  const double width = std::max(largest->width, width_m * mm - none.width);
  const double height = std::max(largest->height, height_m * mm - none.height);
  return place(width, height, "own size", denominator, need);
}

Sheet lay_out_figure(double width_m, double height_m, const Margins_mm& margins,
                     double legend_height) {
  Sheet s;
  s.denominator = 1;
  for (int i = 0; i < kScales; ++i) {
    s.denominator = usual_scale(i);
    if (s.mm_of(width_m) <= kFigureWidth && s.mm_of(height_m) <= kFigureWidth) break;
  }
  s.view = {margins.left, margins.above, s.mm_of(width_m), s.mm_of(height_m)};
  s.width = s.view.right() + margins.right + kLegend;
  s.height = std::max(s.view.bottom() + margins.below, legend_height) + 12;
  s.legend = {s.view.right() + margins.right, 0, kLegend, s.height};
  s.strip = {0, s.height - 12, s.width, 12};
  return s;
}

void open_figure(SvgWriter& svg, const Sheet& sheet, const std::string& title) {
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"xmlns:xlink", "http://www.w3.org/1999/xlink"},
                   {"width", svg_number(sheet.width) + "mm"},
                   {"height", svg_number(sheet.height) + "mm"},
                   {"viewBox", "0 0 " + svg_number(sheet.width) + " " + svg_number(sheet.height)},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, title);
  svg.leaf("rect", {{"width", sheet.width}, {"height", sheet.height}, {"fill", "#ffffff"}});
}

}  // namespace jalon
