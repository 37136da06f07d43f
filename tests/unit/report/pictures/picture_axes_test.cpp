// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Axes of a picture of points: every label stands at the place of its number.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "report/pictures/picture_axes.h"
#include "unit/report/markup.h"

using namespace jalon;

namespace {

struct DrawnLabel {
  double at_mm, value, size_mm;
  std::string text;
};
struct DrawnAxes {
  std::vector<DrawnLabel> right, up;
  std::vector<std::string> names;
};

LabelRaster raster_at(double left, double bottom) {
  LabelRaster out;
  out.columns = 480;
  out.rows = 260;
  out.pixel_m = 0.05;  // 24 x 13 m
  out.low = {left, bottom};
  return out;
}

DrawnAxes axes_of(const LabelRaster& raster, const Sheet& sheet, const PictureAxes& axes) {
  SvgWriter svg;
  svg.open("svg");
  draw_axes(svg, raster, sheet, axes);
  const std::string text = svg.take();
  CHECK(markup::well_formed(text));
  DrawnAxes out;
  for (const markup::Tag& tag : markup::tags(text)) {
    if (tag.name != "text") continue;
    double value = 0;
    if (!parse_number(tag.text_after, value)) {
      out.names.push_back(tag.text_after + "|" + tag.attribute("transform").substr(0, 10));
      continue;
    }
    const double size = markup::number(tag.attribute("font-size"));
    const bool is_right = tag.attribute("text-anchor") == "middle";
    const double at = markup::number(tag.attribute(is_right ? "x" : "y"));
    (is_right ? out.right : out.up).push_back({at, value, size, tag.text_after});
  }
  return out;
}

}  // namespace

TEST_CASE("picture_axes__labels_stand_where_their_numbers_lie") {
  for (const double left : {-3.7, 652001.3}) {
    const LabelRaster raster = raster_at(left, 137.2);
    const Sheet sheet = lay_out_figure(raster.width_m(), raster.height_m());
    const DrawnAxes axes = axes_of(raster, sheet, {"X (m)", "Z (m)"});
    REQUIRE(axes.right.size() >= 3);
    REQUIRE(axes.up.size() >= 3);
    const double half_digit = 0.0006;  // of a coordinate in the drawing
    for (const DrawnLabel& label : axes.right) {
      CHECK(std::abs(label.at_mm - sheet.view.x - sheet.mm_of(label.value - left)) < half_digit);
      CHECK(label.at_mm >= sheet.view.x - half_digit);
      CHECK(label.at_mm <= sheet.view.right() + half_digit);
    }
    for (const DrawnLabel& label : axes.up) {
      // Base lines lie 0.9 mm below the mark.
      CHECK(std::abs(sheet.view.bottom() + 0.9 - label.at_mm - sheet.mm_of(label.value - 137.2)) <
            half_digit);
      CHECK(label.value >= 137.2);
      CHECK(label.value <= 137.2 + 13);
    }
    CHECK(axes.names == std::vector<std::string>{"X (m)|rotate(0)", "Z (m)|rotate(-90"});
  }
}

TEST_CASE("picture_axes__count_from_their_zero_and_keep_their_labels_apart") {
  const LabelRaster raster = raster_at(652001.3, -2);
  const Sheet sheet = lay_out_figure(raster.width_m(), raster.height_m());
  for (const double apart_mm : {10.0, 18.0, 40.0}) {
    PictureAxes axes{"along", "up"};
    axes.right_zero = 652000;
    axes.right_apart_mm = apart_mm;
    axes.up_text_mm = 3.25;
    const DrawnAxes out = axes_of(raster, sheet, axes);
    REQUIRE(!out.right.empty());
    for (const DrawnLabel& label : out.right) {
      CHECK(label.value >= 1.3);
      CHECK(label.value <= 25.3);
      CHECK(std::abs(label.at_mm - sheet.view.x - sheet.mm_of(label.value - 1.3)) < 6e-4);
    }
    for (size_t i = 1; i < out.right.size(); ++i) {
      CHECK(out.right[i].at_mm - out.right[i - 1].at_mm > apart_mm - 2e-3);
      CHECK(out.right[i].text != out.right[i - 1].text);
    }
    // The steps 1, 2, 5: at most 2.5 times as far apart as asked for.
    if (out.right.size() > 1)
      CHECK(out.right[1].at_mm - out.right[0].at_mm < 2.5 * apart_mm + 2e-3);
    for (const DrawnLabel& label : out.up) CHECK(label.size_mm == 3.25);
    for (size_t i = 1; i < out.up.size(); ++i)
      CHECK(out.up[i - 1].at_mm - out.up[i].at_mm > 8 - 2e-3);
  }
}
