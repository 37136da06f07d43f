// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/section_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/files/atomic_file.h"
#include "report/sheet/sheet.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

constexpr double kSheetWidth_mm = 277, kPlanMost_mm = 190;  // A4 landscape within its border
constexpr double kMargin_mm = 8, kAxisLeft_mm = 19, kAxisBelow_mm = 13, kPanelTop_mm = 7,
                 kPanelRight_mm = 4, kKey_mm = 42;
constexpr double kAxisText_mm = 2.5, kTitleText_mm = 3, kLine_mm = 0.35, kThin_mm = 0.2;
constexpr double kTicksApart_mm = 14, kKeyRow_mm = 4.5;
constexpr size_t kMostColumns = 4;
constexpr double kLeastRoomAround_m = 0.1;  // of what is drawn: a single short line
constexpr std::array<const char*, 6> kLineColours = {"#c0392b", "#b9770e", "#1e8449",
                                                     "#148fa8", "#1f5fa8", "#7d3c98"};

struct FlatExtent {
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  void add(const Vec2& p) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  double width() const { return high.u - low.u; }
  double height() const { return high.v - low.v; }
};

// Of all sections in their own axes, with a little room around.
FlatExtent extent_of(const Sections& sections) {
  FlatExtent out;
  for (const Section& section : sections.sections)
    for (const SectionLine& line : section.lines)
      for (const Vec2& p : line.vertices) out.add(p);
  if (!(out.low.u <= out.high.u)) return {{0, 0}, {1, 1}};
  const double room = std::max(0.03 * std::max(out.width(), out.height()), kLeastRoomAround_m);
  out.low = out.low - Vec2{room, room};
  out.high = out.high + Vec2{room, room};
  return out;
}

// A window onto a section: where its lower left corner stands on the paper.
struct SectionPanel {
  FlatExtent extent;
  double left = 0, bottom = 0, mm_per_m = 1;
  Vec2 at(const Vec2& p) const {
    return {left + mm_per_m * (p.u - extent.low.u), bottom - mm_per_m * (p.v - extent.low.v)};
  }
  double right() const { return left + mm_per_m * extent.width(); }
  double top() const { return bottom - mm_per_m * extent.height(); }
};

// shift: from the section's axes to the numbers that its marks tell.
void draw_section_axes(SvgWriter& svg, const SectionPanel& panel, const Vec2& shift,
                       const char* name_u, const char* name_v) {
  const FlatExtent& e = panel.extent;
  const double apart = kTicksApart_mm / panel.mm_per_m;
  const Ticks along = make_ticks(e.low.u + shift.u, e.high.u + shift.u, apart),
              up = make_ticks(e.low.v + shift.v, e.high.v + shift.v, apart * 0.7);
  for (const double value : along.values) {
    const double x = panel.at({value - shift.u, e.low.v}).u;
    svg_line(svg, {x, panel.bottom}, {x, panel.bottom + 1.2}, kInk, kThin_mm);
    svg_text(svg, {x, panel.bottom + 4.2}, kAxisText_mm, Anchor::kMiddle, along.label(value));
  }
  for (const double value : up.values) {
    const double y = panel.at({e.low.u, value - shift.v}).v;
    svg_line(svg, {panel.left - 1.2, y}, {panel.left, y}, kInk, kThin_mm);
    svg_text(svg, {panel.left - 1.8, y + 0.9}, kAxisText_mm, Anchor::kEnd, up.label(value));
  }
  svg_line(svg, {panel.left, panel.bottom}, {panel.right(), panel.bottom}, kInk, kThin_mm);
  svg_line(svg, {panel.left, panel.top()}, {panel.left, panel.bottom}, kInk, kThin_mm);
  svg_text(svg, {(panel.left + panel.right()) / 2, panel.bottom + 8.4}, kAxisText_mm,
           Anchor::kMiddle, name_u);
  svg_text(svg, {panel.left - kAxisLeft_mm + 4, (panel.top() + panel.bottom) / 2}, kAxisText_mm,
           Anchor::kMiddle, name_v, false, true);
}

void draw_section_lines(SvgWriter& svg, const SectionPanel& panel, const Section& section,
                        const char* colour) {
  for (const SectionLine& line : section.lines) {
    std::vector<Vec2> corners;
    for (const Vec2& p : line.vertices) corners.push_back(panel.at(p));
    svg.leaf("path", {{"d", svg_polyline(corners) + (line.is_closed ? "Z" : "")},
                      {"fill", "none"},
                      {"stroke", colour},
                      {"stroke-width", kLine_mm},
                      {"stroke-linejoin", "round"}});
  }
}

// The largest usual scale at which the extent takes no more paper.
double denominator_for(const FlatExtent& extent, double width_mm, double height_mm) {
  return round_up_125(1000 * std::max(extent.width() / width_mm, extent.height() / height_mm));
}

void open_section_sheet(SvgWriter& svg, double height_mm, const char* title, double denominator) {
  Sheet sheet;
  sheet.width = kSheetWidth_mm;
  sheet.height = height_mm;
  open_figure(svg, sheet, title);
  svg_text(svg, {kMargin_mm, kMargin_mm + 2}, 4, Anchor::kStart, title, true);
  svg_text(svg, {kSheetWidth_mm - kMargin_mm, kMargin_mm + 2}, kTitleText_mm, Anchor::kEnd,
           "scale 1 : " + text_of(denominator));
}

// How many sections the key has a row for: the last row may have to tell that there are more.
constexpr size_t kMostKeyRows = 40;
size_t key_rows(const Sections& sections) {
  return std::min(sections.sections.size(), kMostKeyRows);
}

void draw_key(SvgWriter& svg, const Sections& sections, double left, double top) {
  const size_t n = sections.sections.size(), rows = key_rows(sections),
               shown = n <= rows ? n : rows - 1;
  double y = top;
  for (size_t s = 0; s < shown; ++s, y += kKeyRow_mm) {
    svg_line(svg, {left, y}, {left + 6, y}, kLineColours[s % kLineColours.size()], 0.6);
    svg_text(svg, {left + 7.5, y + 1}, kTitleText_mm, Anchor::kStart, sections.name(s));
  }
  if (shown < n)
    svg_text(svg, {left, y + 1}, kTitleText_mm, Anchor::kStart,
             "and " + grouped(n - shown) + " more");
}

std::string plan_of_sections(const Sections& sections) {
  SectionPanel panel;
  panel.extent = extent_of(sections);
  const double denominator = denominator_for(
      panel.extent, kSheetWidth_mm - 2 * kMargin_mm - kAxisLeft_mm - kKey_mm, kPlanMost_mm);
  panel.mm_per_m = 1000 / denominator;
  panel.left = kMargin_mm + kAxisLeft_mm;
  panel.bottom = 2 * kMargin_mm + kPanelTop_mm + panel.mm_per_m * panel.extent.height();
  const double below_key =
      panel.top() + kKeyRow_mm * static_cast<double>(key_rows(sections)) + kMargin_mm;
  SvgWriter svg;
  open_section_sheet(svg, std::max(panel.bottom + kAxisBelow_mm + kMargin_mm, below_key),
                     "Level sections", denominator);
  const Vec3 origin = sections.sections.front().plane.origin;
  draw_section_axes(svg, panel, {origin.x, origin.y}, "x (m)", "y (m)");
  for (size_t s = 0; s < sections.sections.size(); ++s)
    draw_section_lines(svg, panel, sections.sections[s], kLineColours[s % kLineColours.size()]);
  draw_key(svg, sections, kSheetWidth_mm - kMargin_mm - kKey_mm + 6, panel.top() + 2);
  return svg.take();
}

// As many columns as give panels about as wide as the sheet has room for, row by row.
std::string panels_of_sections(const Sections& sections) {
  const FlatExtent extent = extent_of(sections);
  const size_t n = sections.sections.size();
  const double shape = static_cast<double>(n) * extent.height() / extent.width();
  const size_t columns = std::min(
      n, std::clamp<size_t>(static_cast<size_t>(std::ceil(std::sqrt(shape))), 1, kMostColumns));
  const double column_mm = (kSheetWidth_mm - 2 * kMargin_mm) / static_cast<double>(columns);
  const double denominator =
      denominator_for(extent, column_mm - kAxisLeft_mm - kPanelRight_mm, kPlanMost_mm);
  const double mm_per_m = 1000 / denominator;
  const double row_mm = kPanelTop_mm + mm_per_m * extent.height() + kAxisBelow_mm;
  const size_t rows = (n + columns - 1) / columns;
  SvgWriter svg;
  const bool by_alignment = sections.kind == SectionKind::kAlignment;
  open_section_sheet(svg, 3 * kMargin_mm + row_mm * static_cast<double>(rows),
                     by_alignment ? "Cross-sections" : "Sections", denominator);
  for (size_t s = 0; s < n; ++s) {
    SectionPanel panel{extent, 0, 0, mm_per_m};
    panel.left = kMargin_mm + kAxisLeft_mm + column_mm * static_cast<double>(s % columns);
    panel.bottom = 2 * kMargin_mm + row_mm * static_cast<double>(s / columns + 1) - kAxisBelow_mm;
    svg_text(svg, {panel.left, panel.top() - 2}, kTitleText_mm, Anchor::kStart, sections.name(s),
             true);
    if (by_alignment && extent.low.u < 0 && extent.high.u > 0)  // the alignment itself
      svg_line(svg, panel.at({0, extent.low.v}), panel.at({0, extent.high.v}), kFaint, kThin_mm);
    draw_section_axes(svg, panel, {0, 0}, by_alignment ? "offset (m)" : "along (m)", "height (m)");
    draw_section_lines(svg, panel, sections.sections[s], kInk);
  }
  return svg.take();
}

}  // namespace

std::string section_drawing(const Sections& sections) {
  const bool level = sections.kind == SectionKind::kHeight || sections.sections.empty();
  if (sections.sections.empty()) return plan_of_sections({SectionKind::kHeight, {Section{}}, {}});
  return level ? plan_of_sections(sections) : panels_of_sections(sections);
}

void write_section_drawing(const Sections& sections, const std::string& path, Task& task) {
  AtomicFile file(path);
  file.write(section_drawing(sections));
  task.checkpoint(1);
  file.commit();
}

}  // namespace jalon
