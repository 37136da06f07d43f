// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/deviation_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "base/setting_rows.h"
#include "cloud/statistics.h"
#include "compare/landslide/cell_table.h"
#include "formats/png/pictures.h"
#include "report/elevation/title_block.h"
#include "report/pictures/deviation_raster.h"
#include "report/pictures/picture_axes.h"
#include "report/pictures/shown_image.h"
#include "report/pictures/zone_lines.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

using S = DeviationPictureSettings;

constexpr auto kDeviationPictureRows = setting_rows(
    string_row<&S::title>("title", "", "What stands above the picture"),
    choice_row<&S::view>("view", "auto|plan|front|side", "",
                         "plan: X and Y from above; front: X and Z; side: Y and Z; auto: the one "
                         "with the largest extents"),
    number_row<&S::limit_m>("limit_m", 0, 1e9, "m", "",
                            "Distance at the end of the colour scale; 0 = 98 % lie within"));

constexpr double kDeviationPictureText = 2.5, kBarWidth = 5, kBarHeight = 46, kLegend = 70,
                 kZoneKey = 17;

void swatch(SvgWriter& svg, double x, double y, const Rgb& colour, const char* text) {
  svg.leaf("rect", {{"x", x},
                    {"y", y},
                    {"width", kBarWidth},
                    {"height", 3},
                    {"fill", hex_of(colour)},
                    {"stroke", kInk},
                    {"stroke-width", 0.18}});
  svg_text(svg, {x + kBarWidth + 2, y + 2.4}, kDeviationPictureText, Anchor::kStart, text);
}

// The colour scale in millimetres or metres, whatever has fewer digits; gives back where it ends.
double draw_scale(SvgWriter& svg, const DeviationScale& scale, const Sheet& sheet,
                  const char* grey) {
  const double x = sheet.legend.x + 3, top = std::max(sheet.legend.y + 8, sheet.view.y + 4);
  const bool in_mm = scale.limit_m < 1;
  const double factor = in_mm ? 1000 : 1, low = scale.lowest_m() * factor,
               high = scale.limit_m * factor;
  svg_text(svg, {x, top - 2.5}, 2.8, Anchor::kStart, in_mm ? "Distance (mm)" : "Distance (m)",
           true);
  const double step_mm = kBarHeight / DeviationScale::kSteps;
  for (uint32_t step = 0; step < DeviationScale::kSteps; ++step)
    svg.leaf("rect", {{"x", x},
                      {"y", top + kBarHeight - (step + 1) * step_mm},
                      {"width", kBarWidth},
                      {"height", step_mm + 0.05},
                      {"fill", hex_of(scale.colour(step))}});
  svg.leaf("rect", {{"x", x},
                    {"y", top},
                    {"width", kBarWidth},
                    {"height", kBarHeight},
                    {"fill", "none"},
                    {"stroke", kInk},
                    {"stroke-width", 0.2}});
  const Ticks ticks = make_ticks(low, high, (high - low) / 8);
  for (const double value : ticks.values) {
    const double y = top + kBarHeight * (1 - (value - low) / (high - low));
    svg_line(svg, {x + kBarWidth, y}, {x + kBarWidth + 1.2, y}, kInk, 0.18);
    svg_text(svg, {x + kBarWidth + 2, y + 0.9}, kDeviationPictureText, Anchor::kStart,
             ticks.label(value));
  }
  swatch(svg, x, top + kBarHeight + 5, kHiddenColour, "hidden");
  swatch(svg, x, top + kBarHeight + 10, kNotComparedColour, grey);
  return top + kBarHeight + 15;
}

}  // namespace

std::span<const ParamRow> deviation_picture_rows() { return kDeviationPictureRows; }

std::string deviation_svg(const Comparison& comparison, const DeviationScale& scale,
                          const DeviationPictureSettings& settings, Task& task) {
  const ProgressSpan span(task, 0, 1, "drawing the distances");
  const DeviationAxes view = axes_of(comparison, settings.view, task);
  const Projection projection = view.projection(local_origin(*comparison.cloud, task));
  const LabelRaster raster =
      deviation_raster(comparison, scale, projection, settings.only_significant, task);
  const bool is_empty = raster.labels.empty();
  const bool has_zones = is_landslide(comparison);
  const Sheet sheet =
      lay_out_figure(is_empty ? 10 : raster.width_m(), is_empty ? 5 : raster.height_m(), {},
                     kLegend + (has_zones ? kZoneKey : 0));
  SvgWriter svg;
  const std::string title = settings.title.empty() ? "Distances" : settings.title;
  open_figure(svg, sheet, title);
  draw_picture_title(svg, sheet, title);
  const Box_mm& v = sheet.view;
  if (!is_empty) draw_shown_image(svg, v, deviation_image(raster, scale));
  draw_picture_frame(svg, sheet);
  const auto place = [&](const Vec3& p) {
    const Vec2 at = projection.flat(p);
    return Vec2{v.x + (at.u - raster.low.u) / raster.width_m() * v.width,
                v.bottom() - (at.v - raster.low.v) / raster.height_m() * v.height};
  };
  if (!is_empty && has_zones) draw_zone_lines(svg, comparison, place);
  if (!is_empty) draw_picture_marks(svg, settings.marks, place, v);
  if (!is_empty) draw_axes(svg, raster, sheet, {view.right_name(), view.up_name()});
  const double below =
      draw_scale(svg, scale, sheet, settings.only_significant ? "not significant" : "not compared");
  if (!is_empty && has_zones) draw_zone_key(svg, sheet.legend.x + 3, below);
  draw_scale_bar(svg, sheet);
  return svg.take();
}

std::string deviation_png(const Comparison& comparison, const DeviationScale& scale,
                          const DeviationPictureSettings& settings, Task& task) {
  const ProgressSpan span(task, 0, 1, "drawing the distances");
  const DeviationAxes view = axes_of(comparison, settings.view, task);
  LabelRaster raster =
      deviation_raster(comparison, scale, view.projection(local_origin(*comparison.cloud, task)),
                       settings.only_significant, task);
  if (raster.labels.empty()) {  // a picture has at least one pixel
    raster.columns = raster.rows = 1;
    raster.labels.assign(1, LabelRaster::kEmpty);
  }
  return png_of(deviation_image(raster, scale));
}

}  // namespace jalon
