// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/elevation.h"

#include <algorithm>

#include "report/elevation/legend.h"
#include "report/elevation/title_block.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

constexpr double kElevationText = 2.5;

void define_hatching(SvgWriter& svg, const std::string& id, double spacing, const char* colour,
                     double width) {
  svg.open("pattern", {{"id", id},
                       {"width", spacing},
                       {"height", spacing},
                       {"patternUnits", "userSpaceOnUse"},
                       {"patternTransform", "rotate(45)"}});
  svg_line(svg, {0, 0}, {0, spacing}, colour, width);
  svg.close();
}

void define_patterns(SvgWriter& svg, const Sheet& sheet, const std::string& id) {
  svg.open("defs");
  svg.open("clipPath", {{"id", "window" + id}});
  svg.leaf("rect", {{"x", sheet.view.x},
                    {"y", sheet.view.y},
                    {"width", sheet.view.width},
                    {"height", sheet.view.height}});
  svg.close();
  define_hatching(svg, "unknown" + id, 2.2, "#555555", 0.2);
  svg.close();
}

// Tick marks, labels, faint grid, axis names. x counts from the left end of the walls, z is the height of the
// data. The axis of x stands below the dimensions of the ground floor.
void draw_axes(SvgWriter& svg, const ElevationDrawing& drawing) {
  const Sheet& sheet = drawing.sheet;
  const Window& w = drawing.window;
  const double mm = sheet.mm_of(1);
  const Ticks x =
      make_ticks(w.low.u - drawing.faces.wall_low.u, w.high.u - drawing.faces.wall_low.u, 12 / mm);
  const Ticks z = make_ticks(w.low.v, w.high.v, 8 / mm);
  const Box_mm& v = sheet.view;
  const double axis = v.bottom() + margins_for(drawing.dimensions).below - Margins_mm{}.below;
  if (axis > v.bottom()) svg_line(svg, {v.x, axis}, {v.right(), axis}, kInk, 0.18);
  for (const double value : x.values) {
    const double at = drawing.on_paper({value + drawing.faces.wall_low.u, 0}).u;
    svg_line(svg, {at, v.y}, {at, v.bottom()}, kFaint, 0.1);
    svg_line(svg, {at, axis}, {at, axis + 1.5}, kInk, 0.18);
    svg_text(svg, {at, axis + 4.8}, kElevationText, Anchor::kMiddle, x.label(value));
  }
  for (const double value : z.values) {
    const double at = drawing.on_paper({0, value}).v;
    svg_line(svg, {v.x, at}, {v.right(), at}, kFaint, 0.1);
    svg_line(svg, {v.x - 1.5, at}, {v.x, at}, kInk, 0.18);
    svg_text(svg, {v.x - 2.3, at + 0.9}, kElevationText, Anchor::kEnd, z.label(value));
  }
  svg_text(svg, {v.x + v.width / 2, axis + 9.5}, 2.8, Anchor::kMiddle,
           "Distance along the facade (m)");
  svg_text(svg, {v.x - 12.5, v.y + v.height / 2}, 2.8, Anchor::kMiddle, "Height Z (m)", false,
           true);
}

void draw_border(SvgWriter& svg, const Box_mm& box, double width) {
  svg.leaf("rect", {{"x", box.x},
                    {"y", box.y},
                    {"width", box.width},
                    {"height", box.height},
                    {"fill", "none"},
                    {"stroke", kInk},
                    {"stroke-width", width}});
}

}  // namespace

Window window_of(const ElevationFaces& faces) {
  constexpr double kRim = 0.02, kSmallest_m = 0.01;
  if (faces.empty) return {{0, 0}, {1, 1}};
  const double size =
      std::max({faces.high.u - faces.low.u, faces.high.v - faces.low.v, kSmallest_m});
  const Vec2 rim{kRim * size, kRim * size};
  return {Vec2{faces.low.u, std::min(faces.low.v, faces.ground_m)} - rim, faces.high + rim};
}

std::string draw_elevation(const ElevationDrawing& drawing) {
  const Sheet& sheet = drawing.sheet;
  SvgWriter svg;
  const std::string box = "0 0 " + svg_number(sheet.width) + " " + svg_number(sheet.height);
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"width", svg_number(sheet.width) + "mm"},
                   {"height", svg_number(sheet.height) + "mm"},
                   {"viewBox", box},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, drawing.content.title);
  svg.leaf("rect", {{"width", sheet.width}, {"height", sheet.height}, {"fill", "#ffffff"}});
  define_patterns(svg, sheet, drawing.content.id);
  if (drawing.faces.empty) {
    svg_text(svg, {sheet.view.x + sheet.view.width / 2, sheet.view.y + sheet.view.height / 2}, 4,
             Anchor::kMiddle, "no planes to draw");
  } else {
    draw_axes(svg, drawing);
    draw_body(svg, drawing);
    if (drawing.content.labels) draw_labels(svg, drawing);
    if (drawing.content.dimensions) draw_dimensions(svg, drawing);
    draw_legend(svg, legend_items(drawing.faces, drawing.content), sheet);
    draw_scale_bar(svg, sheet);
  }
  draw_border(svg, sheet.view, 0.25);
  if (!drawing.content.outlines_only) {
    draw_title_block(svg, drawing);
    draw_border(svg, sheet.frame, 0.5);
  }
  return svg.take();
}

}  // namespace jalon
