// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/picture_axes.h"

#include <vector>

#include "report/sheet/ticks.h"

namespace jalon {

namespace {

constexpr double kPictureAxesText = 2.5, kNameText = 2.8, kTitleText = 3.2, kUpApart_mm = 8;

}  // namespace

void draw_axes(SvgWriter& svg, const LabelRaster& raster, const Sheet& sheet,
               const PictureAxes& axes) {
  const Box_mm& v = sheet.view;
  const double mm = sheet.mm_of(1), low = raster.low.u - axes.right_zero;
  const Ticks right = make_ticks(low, low + raster.width_m(), axes.right_apart_mm / mm);
  const Ticks up = make_ticks(raster.low.v, raster.low.v + raster.height_m(), kUpApart_mm / mm);
  for (const double value : right.values) {
    const double at = v.x + sheet.mm_of(value + axes.right_zero - raster.low.u);
    svg_line(svg, {at, v.bottom()}, {at, v.bottom() + 1.5}, kInk, 0.18);
    svg_text(svg, {at, v.bottom() + 4.8}, kPictureAxesText, Anchor::kMiddle, right.label(value));
  }
  for (const double value : up.values) {
    const double at = v.bottom() - sheet.mm_of(value - raster.low.v);
    svg_line(svg, {v.x - 1.5, at}, {v.x, at}, kInk, 0.18);
    svg_text(svg, {v.x - 2.3, at + 0.9}, axes.up_text_mm, Anchor::kEnd, up.label(value));
  }
  svg_text(svg, {v.x + v.width / 2, v.bottom() + 9.5}, kNameText, Anchor::kMiddle, axes.right_name);
  svg_text(svg, {v.x - 12.5, v.y + v.height / 2}, kNameText, Anchor::kMiddle, axes.up_name, false,
           true);
}

void draw_picture_title(SvgWriter& svg, const Sheet& sheet, const std::string& title) {
  svg_text(svg, {sheet.view.x, sheet.view.y - 3.5}, kTitleText, Anchor::kStart,
           fitted_text(title, kTitleText, sheet.width - sheet.view.x - 3), true);
}

void draw_picture_frame(SvgWriter& svg, const Sheet& sheet) {
  svg.leaf("rect", {{"x", sheet.view.x},
                    {"y", sheet.view.y},
                    {"width", sheet.view.width},
                    {"height", sheet.view.height},
                    {"fill", "none"},
                    {"stroke", kInk},
                    {"stroke-width", 0.25}});
}

void draw_north_arrow(SvgWriter& svg, const Sheet& sheet) {
  const double x = sheet.view.right() - 5, top = sheet.view.y + 3;
  const std::vector<Vec2> head{{x, top}, {x - 1.6, top + 6}, {x, top + 4.6}, {x + 1.6, top + 6}};
  svg.leaf("path", {{"d", svg_polyline(head) + "Z"}, {"fill", kInk}});
  svg_text(svg, {x, top + 9}, kPictureAxesText, Anchor::kMiddle, "N", true);
}

}  // namespace jalon
