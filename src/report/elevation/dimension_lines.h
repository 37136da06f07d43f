// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "report/sheet/svg_parts.h"

namespace jalon {

/// A chain of dimensions on paper: ticks at these places (mm along the line, in the order of the drawing), between them
/// the distances in metres.
struct DimensionLine {
  std::vector<double> at_mm;
  std::vector<double> values_m;
  double line_mm = 0;  ///< where the line lies: y of a level one, x of an upright one
  double from_mm = 0;  ///< where extension lines begin
  bool is_upright = false;
};

/// Can all its numbers be written, on the line or on its other side, without meeting each other?
bool has_room(const DimensionLine& line);
/// Thin line, oblique ticks, short extension lines, numbers (ISO 129-1 as building drawings use it).
void draw_dimension_line(SvgWriter& svg, const DimensionLine& line);

/// Height marks at these places, the most wanted first; those that would meet one before are left out. ground: place of
/// the mark that reads 0.
struct LevelMarks {
  std::vector<double> at_mm;     ///< y on the paper
  std::vector<double> values_m;  ///< above the ground
  double x_mm = 0;
};
void draw_level_marks(SvgWriter& svg, const LevelMarks& marks);

constexpr double kDimensionStep_mm =
    7.5;  ///< from one dimension line to the next: a number on either side
constexpr double kLevelMark_mm = 13;  ///< width of a level mark

}  // namespace jalon
