// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/deviation_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "base/setting_rows.h"
#include "cloud/statistics.h"
#include "report/elevation/title_block.h"
#include "report/pictures/label_raster.h"
#include "report/pictures/picture_axes.h"
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

constexpr double kDeviationPictureText = 2.5, kBarWidth = 5, kBarHeight = 46, kLegend = 70;
constexpr uint32_t kHiddenLabel = DeviationScale::kSteps + 1;
constexpr const char* kAxisNames[3] = {"X (m)", "Y (m)", "Z (m)"};

// Axes of the picture: to the right, up, and the one that it looks along.
struct View {
  int right = 0, up = 1, into = 2;
};

View view_of(const Comparison& comparison, DeviationView view, Task& task) {
  if (view == DeviationView::kPlan) return {0, 1, 2};
  if (view == DeviationView::kFront) return {0, 2, 1};
  if (view == DeviationView::kSide) return {1, 2, 0};
  // The two longest axes; heights stay upright.
  const Box3 box = bounds(*comparison.cloud, task);
  const Vec3 size = box.max - box.min;
  if (size.z <= std::min(size.x, size.y)) return {0, 1, 2};
  return size.x >= size.y ? View{0, 2, 1} : View{1, 2, 0};
}

Vec3 unit(int axis, double length = 1) {
  Vec3 out;
  out[axis] = length;
  return out;
}

LabelRaster raster_of(const Comparison& comparison, const DeviationScale& scale, const View& view,
                      Task& task) {
  const auto distance = comparison.points.require("distance").values<double>();
  const auto status = comparison.points.require("status").values<uint8_t>();
  std::vector<uint32_t> labels(distance.size());
  parallel_for(task, labels.size(), 1 << 16, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      labels[i] = std::isfinite(distance[i]) ? scale.step_of(distance[i]) + 1
                  : status[i] == static_cast<uint8_t>(CompareStatus::kHidden) ? kHiddenLabel
                                                                              : 0;
  });
  const Vec3 origin = local_origin(*comparison.cloud, task);
  // Plan: seen from above. Front and side: the eye at the low end of the axis looked along.
  const Projection projection{origin,
                              unit(view.right),
                              unit(view.up),
                              unit(view.into, view.into == 2 ? -1 : 1),
                              {origin[view.right], origin[view.up]}};
  return rasterise_points(*comparison.cloud, labels, projection, task);
}

IndexedImage image_of(const LabelRaster& raster, const DeviationScale& scale) {
  IndexedImage image{raster.columns, raster.rows, {}, {{0xff, 0xff, 0xff}, kNotComparedColour}};
  for (uint32_t step = 0; step < DeviationScale::kSteps; ++step)
    image.palette.push_back(scale.colour(step));
  image.palette.push_back(kHiddenColour);
  image.pixels.reserve(raster.labels.size());
  for (const uint32_t label : raster.labels)
    image.pixels.push_back(label == LabelRaster::kEmpty   ? uint8_t{0}
                           : label == LabelRaster::kNoise ? uint8_t{1}
                                                          : static_cast<uint8_t>(label + 1));
  return image;
}

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

// The colour scale in millimetres or metres, whatever has fewer digits.
void draw_scale(SvgWriter& svg, const DeviationScale& scale, const Sheet& sheet) {
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
  swatch(svg, x, top + kBarHeight + 10, kNotComparedColour, "not compared");
}

}  // namespace

std::span<const ParamRow> deviation_picture_rows() { return kDeviationPictureRows; }

std::string deviation_svg(const Comparison& comparison, const DeviationScale& scale,
                          const DeviationPictureSettings& settings, Task& task) {
  const ProgressSpan span(task, 0, 1, "drawing the distances");
  const View view = view_of(comparison, settings.view, task);
  const LabelRaster raster = raster_of(comparison, scale, view, task);
  const bool is_empty = raster.labels.empty();
  const Sheet sheet = lay_out_figure(is_empty ? 10 : raster.width_m(),
                                     is_empty ? 5 : raster.height_m(), {}, kLegend);
  SvgWriter svg;
  const std::string title = settings.title.empty() ? "Distances" : settings.title;
  open_figure(svg, sheet, title);
  svg_text(svg, {sheet.view.x, sheet.view.y - 3.5}, 3.2, Anchor::kStart,
           fitted_text(title, 3.2, sheet.width - sheet.view.x - 3), true);
  const Box_mm& v = sheet.view;
  if (!is_empty)
    svg.leaf("image", {{"x", v.x},
                       {"y", v.y},
                       {"width", v.width},
                       {"height", v.height},
                       {"preserveAspectRatio", "none"},
                       {"style", "image-rendering:pixelated"},
                       {"xlink:href",
                        "data:image/png;base64," + base64_of(png_of(image_of(raster, scale)))}});
  svg.leaf("rect", {{"x", v.x},
                    {"y", v.y},
                    {"width", v.width},
                    {"height", v.height},
                    {"fill", "none"},
                    {"stroke", kInk},
                    {"stroke-width", 0.25}});
  if (!is_empty) draw_axes(svg, raster, sheet, {kAxisNames[view.right], kAxisNames[view.up]});
  draw_scale(svg, scale, sheet);
  draw_scale_bar(svg, sheet);
  return svg.take();
}

std::string deviation_png(const Comparison& comparison, const DeviationScale& scale,
                          const DeviationPictureSettings& settings, Task& task) {
  const ProgressSpan span(task, 0, 1, "drawing the distances");
  LabelRaster raster = raster_of(comparison, scale, view_of(comparison, settings.view, task), task);
  if (raster.labels.empty()) {  // a picture has at least one pixel
    raster.columns = raster.rows = 1;
    raster.labels.assign(1, LabelRaster::kEmpty);
  }
  return png_of(image_of(raster, scale));
}

}  // namespace jalon
