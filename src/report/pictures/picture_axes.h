// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/pictures/label_raster.h"
#include "report/sheet/sheet.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

/// What the axes of a picture of points say, in metres.
struct PictureAxes {
  const char *right_name, *up_name;
  double right_zero = 0;       ///< coordinate at which the axis to the right begins to count
  double right_apart_mm = 18;  ///< of paper: labels are no nearer to each other
  double up_text_mm = 2;       ///< size of the labels of the axis up
};

/// Tick marks, labels and names below and to the left of the picture.
void draw_axes(SvgWriter& svg, const LabelRaster& raster, const Sheet& sheet,
               const PictureAxes& axes);
/// What the picture is, above it, and its border.
void draw_picture_title(SvgWriter& svg, const Sheet& sheet, const std::string& title);
void draw_picture_frame(SvgWriter& svg, const Sheet& sheet);
/// In the upper right corner of a plan whose axis up is north.
void draw_north_arrow(SvgWriter& svg, const Sheet& sheet);

}  // namespace jalon
