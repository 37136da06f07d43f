// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "report/elevation/elevation.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

/// A line of the legend.
struct LegendItem {
  enum class Sign { kHeading, kNote, kSwatch, kLine, kDashes, kCross, kType, kGap };
  Sign sign = Sign::kGap;
  std::string colour;  ///< fill or line; of a type its letters
  std::string text;
  std::string tag, count;  ///< of a type of openings
};

/// Everything that occurs on this drawing, and nothing else.
std::vector<LegendItem> legend_items(const ElevationFaces& faces, const ElevationContent& content);
double legend_height(const std::vector<LegendItem>& items);
/// Lines for which the sheet has no room are counted in a last one.
void draw_legend(SvgWriter& svg, const std::vector<LegendItem>& items, const Sheet& sheet);

}  // namespace jalon
