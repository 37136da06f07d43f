// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/elevation/colours.h"
#include "report/elevation/dimension_chains.h"
#include "report/elevation/faces.h"
#include "report/settings.h"
#include "report/sheet/sheet.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

/// What was asked for, the title with the name of the view, and what the drawing tells of the
/// model.
struct ElevationContent : ElevationSettings {
  std::string id;  ///< ends the names of clips and patterns: several drawings may stand in one page
  uint64_t points = 0;  ///< for the title block
  uint64_t planes = 0;
  bool has_north = false;       ///< the coordinates are a map's: +Y is grid north
  double view_azimuth_rad = 0;  ///< of the eye's direction, clockwise from +Y
};

/// Window of the drawing in facade metres: the box of the faces with a small rim. Never empty.
struct Window {
  Vec2 low, high;
  double width() const { return high.u - low.u; }
  double height() const { return high.v - low.v; }
};
Window window_of(const ElevationFaces& faces);

/// A drawing on its sheet.
struct ElevationDrawing {
  const ElevationFaces& faces;
  const ElevationContent& content;
  Dimensions dimensions;
  Window window;
  Sheet sheet;
  OnPaper on_paper;
};

/// What the faces ask to be dimensioned; nothing when it is not asked for.
Dimensions dimensions_of(const ElevationFaces& faces, const ElevationContent& content);
/// Takes off what has no room for its numbers at the sheet's scale: the narrowest openings first.
void drop_illegible(Dimensions& dimensions, const Sheet& sheet);
/// Room that dimensions take around the window.
Margins_mm margins_for(const Dimensions& dimensions);

/// SVG text of the drawing.
std::string draw_elevation(const ElevationDrawing& drawing);

// The parts of the drawing: elevation_body.cpp, elevation_labels.cpp, elevation_dimensions.cpp.

/// Faces from far to near, each wall's openings after it.
void draw_body(SvgWriter& svg, const ElevationDrawing& drawing);
/// Types of the openings; plane numbers where no opening has a name.
void draw_labels(SvgWriter& svg, const ElevationDrawing& drawing);
void draw_dimensions(SvgWriter& svg, const ElevationDrawing& drawing);

}  // namespace jalon
