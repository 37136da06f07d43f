// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/title_block.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text_number.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

constexpr double kTitleBlockText = 2.5;
constexpr double kBlockWidth = 185, kBlockShare = 0.62;  // of the strip, at most
constexpr double kScaleBarRoom = 73;                     // left of the plan of the view

struct Cell {
  const char* name;
  std::string text;
  double size;
  double share;  ///< of the row's width
  bool is_optional = false;
};

void draw_cell(SvgWriter& svg, const Box_mm& box, const Cell& cell) {
  svg.leaf("rect", {{"x", box.x},
                    {"y", box.y},
                    {"width", box.width},
                    {"height", box.height},
                    {"fill", "none"},
                    {"stroke", kInk},
                    {"stroke-width", 0.18}});
  svg_text(svg, {box.x + 1.5, box.y + 2.6}, 1.8, Anchor::kStart, cell.name, false, false, kGrey);
  svg_text(svg, {box.x + 1.5, box.bottom() - 1.8}, cell.size, Anchor::kStart,
           fitted_text(cell.text, cell.size, box.width - 3), cell.size > 3);
}

// The cells share the row; what is optional and not given is left out.
void draw_row(SvgWriter& svg, Box_mm row, std::vector<Cell> cells) {
  std::erase_if(cells, [](const Cell& cell) { return cell.is_optional && cell.text.empty(); });
  double shares = 0;
  for (const Cell& cell : cells) shares += cell.share;
  const double width = row.width;
  for (const Cell& cell : cells) {
    row.width = width * cell.share / shares;
    draw_cell(svg, row, cell);
    row.x += row.width;
  }
}

double degrees(double azimuth_rad) {
  // Rounded as shown, so that a hair below north is 0.0 and not 360.0.
  const double shown = std::round(azimuth_rad * 1800 / std::numbers::pi) / 10;
  return shown < 0 ? shown + 360 : shown;
}

std::string contents(const ElevationDrawing& drawing) {
  const ElevationContent& s = drawing.content;
  return grouped(s.points) + " points, " + grouped(s.planes) + " planes" +
         (drawing.faces.main_sigma_m > 0
              ? ", \xCF\x83 " + text_of(1000 * drawing.faces.main_sigma_m, 1) + " mm (main plane)"
              : "");
}

std::string corner(const ElevationFaces& faces) {
  return text_of(faces.corner_world.x, 3) + ", " + text_of(faces.corner_world.y, 3) + ", " +
         text_of(faces.corner_world.z, 3);
}

void draw_arrow(SvgWriter& svg, const Vec2& from, const Vec2& to, const char* colour) {
  const Vec2 d = (to - from) * (1 / norm(to - from)), side{-d.v, d.u};
  svg_line(svg, from, to, colour, 0.3);
  const std::vector<Vec2> head{to, to - d * 2.2 + side * 0.9, to - d * 2.2 - side * 0.9};
  svg.leaf("path", {{"d", svg_polyline(head) + "Z"}, {"fill", colour}});
}

// North up; the facade as a thick line; the eye's direction as an arrow on it.
void draw_view_plan(SvgWriter& svg, const Vec2& centre, const ElevationContent& content) {
  constexpr double kRadius = 8;
  const Vec2 look{std::sin(content.view_azimuth_rad), -std::cos(content.view_azimuth_rad)};
  const Vec2 along{-look.v, look.u};
  svg.leaf("circle", {{"cx", centre.u},
                      {"cy", centre.v},
                      {"r", kRadius},
                      {"fill", "none"},
                      {"stroke", kFaint},
                      {"stroke-width", 0.18}});
  svg_line(svg, centre - along * (kRadius * 0.8), centre + along * (kRadius * 0.8), kInk, 0.7);
  draw_arrow(svg, centre - look * kRadius, centre - look * 0.6, "#b3472f");
  const Vec2 north = centre + Vec2{kRadius + 6, 0};
  draw_arrow(svg, north + Vec2{0, kRadius * 0.8}, north - Vec2{0, kRadius * 0.5}, kInk);
  svg_text(svg, north - Vec2{0, kRadius * 0.5 + 1.2}, kTitleBlockText, Anchor::kMiddle,
           content.has_north ? "N" : "+Y", true);
}

}  // namespace

void draw_scale_bar(SvgWriter& svg, const Sheet& sheet) {
  // Four to five fields of a round length, together about 60 mm.
  const double field_m = round_up_125(60.0 / 5 / sheet.mm_of(1)), field = sheet.mm_of(field_m);
  const int fields = std::clamp(static_cast<int>(66 / field), 2, 5);
  const double x = sheet.strip.x + 10, height = 2;
  const double y = sheet.strip.y + (sheet.frame.width > 0 ? 17 : 2);
  const int decimals = make_ticks(0, field_m, field_m).decimals;
  for (int i = 0; i < fields; ++i)
    svg.leaf("rect", {{"x", x + i * field},
                      {"y", y},
                      {"width", field},
                      {"height", height},
                      {"fill", i % 2 == 0 ? kInk : "#ffffff"},
                      {"stroke", kInk},
                      {"stroke-width", 0.18}});
  for (int i = 0; i <= fields; ++i)
    svg_text(svg, {x + i * field, y + height + 3.2}, kTitleBlockText, Anchor::kMiddle,
             text_of(i * field_m, decimals));
  svg_text(svg, {x + fields * field + 4, y + height + 3.2}, kTitleBlockText, Anchor::kStart, "m");
  if (sheet.frame.width > 0)
    svg_text(svg, {x, y - 3}, 3, Anchor::kStart, "Scale 1:" + std::to_string(sheet.denominator),
             true);
}

void draw_title_block(SvgWriter& svg, const ElevationDrawing& drawing) {
  const Sheet& sheet = drawing.sheet;
  const ElevationContent& s = drawing.content;
  const double width = std::min(kBlockWidth, sheet.strip.width * kBlockShare),
               x = sheet.strip.right() - width;
  const double y = sheet.strip.y, row = sheet.strip.height / 3;
  svg_line(svg, {sheet.strip.x, y}, {sheet.strip.right(), y}, kInk, 0.35);
  if (x - sheet.strip.x > kScaleBarRoom + 30)
    draw_view_plan(svg, {sheet.strip.x + kScaleBarRoom + 14, y + sheet.strip.height / 2}, s);
  const std::string ground = drawing.faces.empty ? ""
                                                 : "\xC2\xB1"
                                                   "0.00 = Z " +
                                                       text_of(drawing.faces.ground_m, 2);
  const std::string azimuth = text_of(degrees(s.view_azimuth_rad), 1) + "\xC2\xB0";
  draw_row(svg, {x, y, width, row},
           {{"Title", s.title, 4.2, 0.7}, {"Date", s.date, 2.6, 0.15, true}});
  draw_row(svg, {x, y + row, width, row},
           {{"Source", s.source, 2.3, 0.24, true},
            {"Contents", contents(drawing), 2.3, 0.42},
            {"Left lower corner, main plane: X, Y, Z (m)", corner(drawing.faces), 2.3, 0.34}});
  draw_row(
      svg, {x, y + 2 * row, width, row},
      {{"Scale", "1:" + std::to_string(sheet.denominator) + "  (" + sheet.paper + ")", 3.2, 0.22},
       {s.has_north ? "Direction of view from north" : "Direction of view from +Y", azimuth, 2.5,
        0.24},
       {"Level of the ground (m)", ground, 2.5, 0.24, true},
       {"Units; drawn by", "metres; Jalon", 2.5, 0.22}});
}

}  // namespace jalon
