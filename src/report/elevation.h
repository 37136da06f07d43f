// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/elevation_faces.h"
#include "report/sheet.h"

namespace jalon {

struct ElevationSetting {
  std::string title = "Facade elevation";
  bool is_sheet = true;  ///< with border and title block; else a figure for a page
  bool labels = true;
  bool dimensions = true;
  uint64_t points = 0;   ///< for the title block
  uint64_t planes = 0;
  double view_azimuth_rad = 0;  ///< of the eye's direction, clockwise from +Y (grid north)
};

/// SVG text of the drawing on that sheet.
std::string draw_elevation(const ElevationFaces& faces, const Sheet& sheet, const ElevationSetting& setting);

/// Window of the drawing in facade metres: the box of the faces with a small rim. Never empty.
struct Window {
  Vec2 low, high;
  double width() const { return high.u - low.u; }
  double height() const { return high.v - low.v; }
};
Window window_of(const ElevationFaces& faces);

/// Colour of group i of n, near to far: light to dark.
std::string depth_colour(size_t i, size_t n);

}  // namespace jalon
