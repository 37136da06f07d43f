// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "formats/drawings/svg_writer.h"

namespace jalon {

struct Box_mm {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

/// Layout of a drawing sheet; everything in millimetres from the top left corner of the paper.
struct Sheet {
  std::string paper;          ///< "A3", "A3 upright", or "" for a drawing embedded in a page
  int64_t denominator = 100;  ///< scale 1 : denominator
  double width = 0, height = 0;
  Box_mm frame;          ///< border line
  Box_mm view;           ///< the drawing's window, to scale
  Box_mm legend, strip;  ///< right column; bottom strip with scale bar and title block
  double mm_of(double metres) const { return metres * 1000 / static_cast<double>(denominator); }
};

/// Room around the window: tick labels and axis names left and below, dimension lines above and to the right.
struct Margins_mm {
  double left = 17, below = 14, above = 12, right = 11;
};

/// The sheet for a window of width x height metres. paper: "auto", "A4" ... "A0", landscape, or upright from A3
/// on where that fits better; denominator 0 = the largest usual scale that fits (auto: on A3, and then A4 if it fits
/// there too). A scale that is asked for and fits no paper gives a
/// sheet of its own size.
Sheet lay_out_sheet(double width_m, double height_m, const std::string& paper, int64_t denominator,
                    const Margins_mm& margins = {});

/// The same without border and title block, as small as its content: the window at most 170 mm either way, beside it
/// the margins and the legend of 50 mm. legend_height: room that the legend needs, mm.
Sheet lay_out_figure(double width_m, double height_m, const Margins_mm& margins = {},
                     double legend_height = 75);

/// Begins the drawing of a figure, with raster pictures: its size in mm, its title, white paper.
void open_figure(SvgWriter& svg, const Sheet& sheet, const std::string& title);

}  // namespace jalon
