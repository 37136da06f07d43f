// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/picture.h"

#include <algorithm>
#include <utility>

#include "base/setting_rows.h"
#include "base/text_number.h"
#include "formats/png/pictures.h"
#include "report/elevation/title_block.h"
#include "report/pictures/code_plan.h"
#include "report/pictures/label_colours.h"
#include "report/pictures/label_numbers.h"
#include "report/pictures/picture_axes.h"
#include "report/pictures/shown_image.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

namespace {

constexpr auto kPictureRows =
    setting_rows(string_row<&PictureSettings::title>(
                     "title", "", "What stands before the kind of view in the title"),
                 choice_row<&PictureSettings::view>(
                     "view", "front|plan", "",
                     "front: the facade frame from the station side; plan: X and Y from above"),
                 bool_row<&PictureSettings::numbers>(
                     "numbers", "", "Segment numbers on segments that have room for them"));

constexpr double kPictureText = 2.5, kRow = 4.2, kSwatch = 6;

struct Picture {
  const Segmentation& segmentation;
  LabelRaster raster;
  std::vector<uint8_t> colours;
  PictureView view;
  Sheet sheet;
};

void draw_image(SvgWriter& svg, const Picture& picture) {
  draw_shown_image(svg, picture.sheet.view, image_of(picture.raster, picture.colours));
}

// Front: x counts from the left end of the picture, as on the elevation; plan: X and Y of the data.
PictureAxes axes_of(const Picture& picture) {
  if (picture.view == PictureView::kFront)
    return {"Distance along the facade (m)", "Height Z (m)", picture.raster.low.u, 12,
            kPictureText};
  return {"X (m)", "Y (m)"};
}

// A white border keeps numbers readable on any colour.
void draw_numbers(SvgWriter& svg, const Picture& picture) {
  const double mm = picture.sheet.mm_of(picture.raster.pixel_m);
  for (const LabelNumber& number : place_numbers(picture.raster, kPictureText / mm)) {
    const Box_mm& v = picture.sheet.view;
    const Vec2 at{v.x + mm * (number.column + 0.5),
                  v.y + mm * (number.row + 0.5) + 0.36 * kPictureText};
    const std::string text = std::to_string(number.label);
    svg.element("text",
                {{"x", at.u},
                 {"y", at.v},
                 {"font-size", kPictureText},
                 {"text-anchor", "middle"},
                 {"fill", "#ffffff"},
                 {"stroke", "#ffffff"},
                 {"stroke-width", 0.7},
                 {"stroke-linejoin", "round"}},
                text);
    svg_text(svg, at, kPictureText, Anchor::kMiddle, text);
  }
}

void swatch(SvgWriter& svg, double x, double y, const Rgb& colour, const std::string& text) {
  svg.leaf("rect", {{"x", x},
                    {"y", y},
                    {"width", kSwatch},
                    {"height", 3},
                    {"fill", hex_of(colour)},
                    {"stroke", kInk},
                    {"stroke-width", 0.18}});
  svg_text(svg, {x + kSwatch + 2, y + 2.5}, kPictureText, Anchor::kStart, text);
}

void draw_legend(SvgWriter& svg, const Picture& picture) {
  const Segmentation& s = picture.segmentation;
  const Box_mm& box = picture.sheet.legend;
  const double x = box.x + 3;
  double y = std::max(box.y + 4, picture.sheet.view.y);
  uint64_t noise = s.cloud->size();
  for (const Segment& segment : s.segments) noise -= segment.point_count();
  svg_text(svg, {x, y + 2}, 2.8, Anchor::kStart, "Segments (points)", true);
  y += 4.5;
  const size_t rows = static_cast<size_t>(std::max(1.0, (box.bottom() - 14 - y) / kRow - 2));
  for (size_t i = 0; i < std::min(rows, s.segments.size()); ++i, y += kRow)
    swatch(
        svg, x, y, segment_palette()[picture.colours[i]],
        std::to_string(s.segments[i].label) + "  (" + grouped(s.segments[i].point_count()) + ")");
  if (s.segments.size() > rows) {
    svg_text(svg, {x, y + 2.5}, kPictureText, Anchor::kStart,
             "and " + std::to_string(s.segments.size() - rows) + " smaller ones");
    y += kRow;
  }
  swatch(svg, x, y, kNoiseColour, "noise  (" + grouped(noise) + ")");
}

std::string title_of(const Picture& picture, const PictureSettings& settings) {
  const std::string& title = settings.title;
  const char* kind = picture.view == PictureView::kFront ? "front view" : "plan view";
  return (title.empty() ? "" : title + ": ") + kind + ", " +
         grouped(picture.segmentation.segments.size()) + " segments of " +
         grouped(picture.segmentation.cloud->size()) + " points";
}

}  // namespace

std::span<const ParamRow> picture_rows() { return kPictureRows; }

std::string picture_svg(const Segmentation& segmentation, const PictureSettings& settings,
                        Task& task) {
  if (settings.view == PictureView::kPlan && !segmentation.notes_json.empty())
    return code_plan_svg(segmentation, read_coded_notes(segmentation.notes_json), settings.title,
                         task);
  const ProgressSpan span(task, 0, 1, "drawing the segments");
  return picture_svg(segmentation, settings, rasterise_labels(segmentation, settings.view, task),
                     task);
}

std::string picture_svg(const Segmentation& segmentation, const PictureSettings& settings,
                        LabelRaster raster, Task& task) {
  task.checkpoint(1);
  Picture picture{segmentation, std::move(raster), {}, settings.view, {}};
  picture.colours = colour_labels(picture.raster, segmentation.segments.size());
  const bool is_empty = picture.raster.labels.empty();
  picture.sheet = is_empty ? lay_out_figure(10, 5)
                           : lay_out_figure(picture.raster.width_m(), picture.raster.height_m());
  const Sheet& sheet = picture.sheet;
  SvgWriter svg;
  const std::string title = title_of(picture, settings);
  open_figure(svg, sheet, title);
  draw_picture_title(svg, sheet, title);
  if (is_empty) {
    svg_text(svg, {sheet.view.x + 30, sheet.view.y + 20}, 4, Anchor::kMiddle, "no points to draw");
    return svg.take();
  }
  draw_image(svg, picture);
  draw_picture_frame(svg, sheet);
  draw_axes(svg, picture.raster, picture.sheet, axes_of(picture));
  if (settings.numbers) draw_numbers(svg, picture);
  draw_legend(svg, picture);
  draw_scale_bar(svg, sheet);
  return svg.take();
}

std::string picture_png(const Segmentation& segmentation, const PictureSettings& settings,
                        Task& task) {
  const ProgressSpan span(task, 0, 1, "drawing the segments");
  LabelRaster raster = rasterise_labels(segmentation, settings.view, task);
  if (raster.labels.empty()) {  // a picture has at least one pixel
    raster.columns = raster.rows = 1;
    raster.labels.assign(1, LabelRaster::kEmpty);
  }
  return png_of(image_of(raster, colour_labels(raster, segmentation.segments.size())));
}

}  // namespace jalon
