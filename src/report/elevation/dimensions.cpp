// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "report/elevation/dimension_lines.h"
#include "report/elevation/elevation.h"

namespace jalon {

namespace {

constexpr double kFirst_mm = 5;      // from the window to the first dimension line
constexpr double kMarkRoom_mm = 1;   // between window and level marks
constexpr double kBelowLine_mm = 5;  // a number below its line, and air
constexpr double kLongShare = 0.5;   // of the facade's width: a cornice or string course
constexpr size_t kFewest = 3;        // places of a chain that tells more than the overall dimension

DimensionLine line_of(const std::vector<double>& at, const ElevationDrawing& drawing,
                      double line_mm, double from_mm, bool is_upright) {
  DimensionLine line;
  line.line_mm = line_mm;
  line.from_mm = from_mm;
  line.is_upright = is_upright;
  for (size_t i = 0; i < at.size(); ++i) {
    line.at_mm.push_back(is_upright ? drawing.on_paper({0, at[i]}).v
                                    : drawing.on_paper({at[i], 0}).u);
    if (i > 0) line.values_m.push_back(at[i] - at[i - 1]);
  }
  return line;
}

bool tells_more(const std::vector<double>& chain) { return chain.size() >= kFewest; }

// Above: columns, axes, overall, outward.
void draw_above(SvgWriter& svg, const ElevationDrawing& drawing) {
  const double from = drawing.sheet.view.y - 0.5;
  double y = drawing.sheet.view.y - kFirst_mm;
  for (const auto& chain : {drawing.dimensions.columns.sides(), drawing.dimensions.axes}) {
    if (!tells_more(chain)) continue;
    draw_dimension_line(svg, line_of(chain, drawing, y, from, false));
    y -= kDimensionStep_mm;
  }
  const ElevationFaces& faces = drawing.faces;
  draw_dimension_line(svg, line_of({faces.wall_low.u, faces.wall_high.u}, drawing, y, from, false));
}

// To the right: level marks, sills and heads, overall.
void draw_right(SvgWriter& svg, const ElevationDrawing& drawing) {
  const Box_mm& view = drawing.sheet.view;
  LevelMarks marks;
  marks.x_mm = view.right() + kMarkRoom_mm;
  for (const double level : drawing.dimensions.levels) {
    if (level < drawing.window.low.v || level > drawing.window.high.v) continue;
    marks.at_mm.push_back(drawing.on_paper({0, level}).v);
    marks.values_m.push_back(level - drawing.faces.ground_m);
  }
  draw_level_marks(svg, marks);
  const double from = marks.x_mm + kLevelMark_mm;
  double x = from + kFirst_mm - 1;
  const auto rows = drawing.dimensions.rows.sides();
  if (tells_more(rows)) {
    draw_dimension_line(svg, line_of(rows, drawing, x, from, true));
    x += kDimensionStep_mm;
  }
  draw_dimension_line(svg,
                      line_of({drawing.faces.low.v, drawing.faces.high.v}, drawing, x, from, true));
}

}  // namespace

Dimensions dimensions_of(const ElevationFaces& faces, const ElevationContent& content) {
  if (!content.dimensions || faces.empty) return {};
  std::vector<OpeningBox> openings, long_boxes;
  for (const DrawnOpening& o : faces.openings) openings.push_back({o.low, o.high});
  for (const DrawnFace& face : faces.faces) {
    if (face.kind != DrawnFace::Kind::kFront || face.role != DrawnFace::Role::kElement) continue;
    OpeningBox box{{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (const Vec2& p : face.rings.front().polygon) {
      box.low = {std::min(box.low.u, p.u), std::min(box.low.v, p.v)};
      box.high = {std::max(box.high.u, p.u), std::max(box.high.v, p.v)};
    }
    if (box.high.u - box.low.u >= kLongShare * (faces.high.u - faces.low.u))
      long_boxes.push_back(box);
  }
  // Across, the walls are measured, without the cornices that stand out beside them.
  const OpeningBox facade{{faces.wall_low.u, faces.low.v}, {faces.wall_high.u, faces.high.v}};
  return find_dimensions(openings, long_boxes, facade, faces.ground_m, kTypeTolerance_m);
}

Margins_mm margins_for(const Dimensions& d) {
  Margins_mm out;
  if (d.levels.empty()) return out;
  const auto steps = [](const std::vector<double>& chain) {
    return tells_more(chain) ? kDimensionStep_mm : 0;
  };
  out.above += steps(d.columns.sides()) + steps(d.axes);
  out.right += kMarkRoom_mm + kLevelMark_mm + steps(d.rows.sides());
  if (tells_more(d.ground_floor.sides())) out.below += kFirst_mm + kBelowLine_mm;
  return out;
}

void drop_illegible(Dimensions& d, const Sheet& sheet) {
  const auto is_legible = [&](const std::vector<double>& at) {
    DimensionLine line;
    for (size_t i = 0; i < at.size(); ++i) {
      line.at_mm.push_back(sheet.mm_of(at[i] - at[0]));
      if (i > 0) line.values_m.push_back(at[i] - at[i - 1]);
    }
    return has_room(line);
  };
  for (auto* chain : {&d.columns, &d.ground_floor, &d.rows})
    while (!is_legible(chain->sides())) chain->drop_narrowest();
  if (!is_legible(d.axes)) d.axes.clear();
}

void draw_dimensions(SvgWriter& svg, const ElevationDrawing& drawing) {
  draw_above(svg, drawing);
  draw_right(svg, drawing);
  const double bottom = drawing.sheet.view.bottom();
  const auto chain = drawing.dimensions.ground_floor.sides();
  if (tells_more(chain))
    draw_dimension_line(svg, line_of(chain, drawing, bottom + kFirst_mm, bottom + 0.5, false));
}

}  // namespace jalon
