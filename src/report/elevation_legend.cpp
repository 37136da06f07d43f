// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation_legend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text_number.h"
#include "report/ticks.h"

namespace jalon {

namespace {

constexpr double kText = 2.5, kRow = 5;

std::string depth_text(double depth_m) {
  const std::string number = text_of(depth_m, 2);
  const bool is_positive = number.front() != '-' && number != "0.00";
  return std::string(is_positive ? "+" : "").append(number);
}

std::string group_text(const DepthGroup& group) {
  const std::string from = depth_text(group.from_m), to = depth_text(group.to_m);
  return (from == to ? from : from + " to " + to) + (group.faces > 1 ? " (" + std::to_string(group.faces) + ")" : "");
}

void cell(SvgWriter& svg, const Box_mm& box, std::string_view name, std::string_view text, double size) {
  svg.leaf("rect", {{"x", box.x},
                    {"y", box.y},
                    {"width", box.width},
                    {"height", box.height},
                    {"fill", "none"},
                    {"stroke", kInk},
                    {"stroke-width", 0.18}});
  svg_text(svg, {box.x + 1.5, box.y + 2.6}, 1.8, Anchor::kStart, name, false, false, kGrey);
  svg_text(svg, {box.x + 1.5, box.bottom() - 1.8}, size, Anchor::kStart, fitted_text(text, size, box.width - 3),
           size > 3);
}

}  // namespace

void draw_legend(SvgWriter& svg, const ElevationFaces& faces, const Sheet& sheet) {
  const double x = sheet.legend.x + 3, swatch = 7;
  double y = sheet.legend.y + 8;
  if (!faces.groups.empty()) {
    svg_text(svg, {x, y}, 2.8, Anchor::kStart, "Depth from main plane (m)", true);
    svg_text(svg, {x, y + 3.6}, 2, Anchor::kStart, "+ behind, - in front; (n) faces", false, false, kGrey);
    y += 6.5;
  }
  for (size_t i = 0; i < faces.groups.size(); ++i, y += kRow) {
    svg.leaf("rect", {{"x", x},
                      {"y", y},
                      {"width", swatch},
                      {"height", 3.6},
                      {"fill", depth_colour(i, faces.groups.size())},
                      {"stroke", kInk},
                      {"stroke-width", 0.18}});
    svg_text(svg, {x + swatch + 2, y + 2.8}, kText, Anchor::kStart, group_text(faces.groups[i]));
  }
  const auto has = [&](DrawnFace::Kind kind) {
    return std::any_of(faces.faces.begin(), faces.faces.end(), [&](const DrawnFace& f) { return f.kind == kind; });
  };
  y += 3;
  if (has(DrawnFace::Kind::kEdgeOn)) {
    svg_line(svg, {x, y + 1.8}, {x + swatch, y + 1.8}, "#b3472f", 0.35);
    svg_text(svg, {x + swatch + 2, y + 2.7}, kText, Anchor::kStart, "plane seen edge-on");
    y += kRow;
  }
  if (has(DrawnFace::Kind::kSlanted)) {
    svg.leaf("rect", {{"x", x},
                      {"y", y},
                      {"width", swatch},
                      {"height", 3.6},
                      {"fill", "url(#slanted)"},
                      {"stroke", kGrey},
                      {"stroke-width", 0.18}});
    svg_text(svg, {x + swatch + 2, y + 2.8}, kText, Anchor::kStart, "inclined plane");
    y += kRow;
  }
  svg.leaf("rect", {{"x", x},
                    {"y", y},
                    {"width", swatch},
                    {"height", 3.6},
                    {"fill", "#ffffff"},
                    {"stroke", kInk},
                    {"stroke-width", 0.25}});
  svg_text(svg, {x + swatch + 2, y + 2.8}, kText, Anchor::kStart, "opening or no points");
}

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
    svg_text(svg, {x + i * field, y + height + 3.2}, kText, Anchor::kMiddle, text_of(i * field_m, decimals));
  svg_text(svg, {x + fields * field + 4, y + height + 3.2}, kText, Anchor::kStart, "m");
  if (sheet.frame.width > 0)
    svg_text(svg, {x, y - 3}, 3, Anchor::kStart, "Scale 1:" + std::to_string(sheet.denominator), true);
}

void draw_title_block(SvgWriter& svg, const ElevationFaces& faces, const Sheet& sheet,
                      const ElevationSetting& setting) {
  const double width = std::min(150.0, sheet.strip.width * 0.6), x = sheet.strip.right() - width, y = sheet.strip.y;
  const double half = width / 2, third = width / 3, row = sheet.strip.height / 3;
  // Rounded as shown, so that a hair below north is 0.0 and not 360.0.
  double azimuth = std::round(setting.view_azimuth_rad * 1800 / std::numbers::pi) / 10;
  if (azimuth < 0) azimuth += 360;
  svg_line(svg, {sheet.strip.x, y}, {sheet.strip.right(), y}, kInk, 0.35);
  cell(svg, {x, y, width, row}, "Title", setting.title, 4.2);
  cell(svg, {x, y + row, half, row}, "Contents",
       "Elevation from " + grouped(setting.points) + " points, " + grouped(setting.planes) + " planes", 2.3);
  cell(svg, {x + half, y + row, half, row}, "Left lower corner of the drawing, main plane: X, Y, Z (m)",
       text_of(faces.corner_world.x, 3) + ", " + text_of(faces.corner_world.y, 3) + ", " +
           text_of(faces.corner_world.z, 3),
       2.3);
  cell(svg, {x, y + 2 * row, third, row}, "Scale", "1:" + std::to_string(sheet.denominator) + "  (" + sheet.paper + ")",
       3.2);
  cell(svg, {x + third, y + 2 * row, third, row}, "Direction of view, from +Y clockwise",
       text_of(azimuth, 1) + "\xC2\xB0", 2.6);
  cell(svg, {x + 2 * third, y + 2 * row, third, row}, "Units; drawn by", "metres; Jalon", 2.6);
}

}  // namespace jalon
