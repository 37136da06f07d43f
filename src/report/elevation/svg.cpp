// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/elevation.h"
#include "report/elevation/legend.h"
#include "report/report.h"

namespace jalon {

namespace {

constexpr ParamRow kElevationRows[] = {
    string_row("title", "Facade elevation", "", "Title of the drawing"),
    string_row("source", "", "", "What the drawing was made from, for the title block; empty = left out"),
    string_row("date", "", "", "Date for the title block; empty = left out"),
    choice_row("paper", "auto", "auto|A4|A3|A2|A1|A0", "",
               "Paper, landscape, or upright from A3 on where that fits better; auto = A3, or A4 where it holds the "
               "same scale"),
    integer_row("scale", 0, 0, 1e9, "1", "",
                "Denominator of the scale (100 = 1:100); 0 = the largest usual one that fits"),
    integer_row("facade", 0, 0, 1e9, "1", "",
                "0 = the whole model from the front of its main facade; k = its k-th facade alone, from its own front"),
    number_row("in_front_m", 10, 0, 1e6, "m", "",
               "Faces further than this (a depth) in front of the main plane are left out"),
    number_row("behind_m", 10, 0, 1e6, "m", "", "Faces further than this (a depth) behind the main plane are left out"),
    number_row("element_reach_m", 3, 0, 1e6, "m", "",
               "Elements that stand further than this (a depth) in front of every wall are left out: cars, trees"),
    number_row("front_angle_rad", 0.26, 0, 0.8, "rad", "",
               "Faces turned from the facade by less than this are filled by depth"),
    choice_row("colours", "sides", "sides|depth|none", "",
               "sides: red in front of the main plane, green behind it; depth: one scale from near to far; none: lines "
               "alone"),
    number_row("type_tolerance_m", kTypeTolerance_m, 0, 10, "m", "",
               "Openings whose width and height agree within this are of one type"),
    bool_row("labels", true, "", "Types of the openings on them; plane numbers where no opening has a name"),
    bool_row("dimensions", true, "", "Chains of dimensions and height marks"),
    bool_row("outlines_only", false, "", "Without border and title block: a figure for another page"),
};

ElevationColours colours_of(const std::string& name) {
  return name == "sides" ? ElevationColours::kSides : name == "depth" ? ElevationColours::kDepth
                                                                      : ElevationColours::kNone;
}

ElevationSetting read_setting(const Segmentation& segmentation, const ElevationView& view, const ParamSet& options) {
  ElevationSetting out;
  out.title = options.text("title") + (view.name.empty() ? "" : ": " + view.name);
  out.source = options.text("source");
  out.date = options.text("date");
  out.id = options.integer("facade") == 0 ? "" : "-" + std::to_string(options.integer("facade"));
  out.colours = colours_of(options.text("colours"));
  out.is_sheet = !options.flag("outlines_only");
  out.labels = options.flag("labels");
  out.dimensions = options.flag("dimensions");
  out.points = segmentation.cloud->size();
  out.planes = plane_count(segmentation.segments);
  out.has_north = !segmentation.cloud->crs.empty();
  out.view_azimuth_rad = view.azimuth_rad();
  return out;
}

Sheet lay_out(const ElevationDrawing& drawing, const ParamSet& options) {
  const Window& window = drawing.window;
  const Margins_mm margins = margins_for(drawing.dimensions);
  if (drawing.setting.is_sheet)
    return lay_out_sheet(window.width(), window.height(), options.text("paper"), options.integer("scale"), margins);
  return lay_out_figure(window.width(), window.height(), margins,
                        legend_height(legend_items(drawing.faces, drawing.setting)));
}

}  // namespace

std::span<const ParamRow> elevation_rows() { return kElevationRows; }

std::string elevation_svg(const Segmentation& segmentation, const Model& model, const ParamSet& options, Task& task) {
  const Span span(task, 0, 1, "drawing the elevation");
  OpeningList openings = list_openings(model, options.number("type_tolerance_m"));
  const ElevationView view = elevation_view(segmentation, model, openings, options.integer("facade"));
  const ElevationSetting setting = read_setting(segmentation, view, options);
  const ViewLimits limits{options.number("in_front_m"), options.number("behind_m"), options.number("element_reach_m"),
                          options.number("front_angle_rad")};
  ElevationFaces faces = elevation_faces(model, view, limits, task);
  faces.list = std::move(openings);
  add_openings(faces, model, view);
  ElevationDrawing drawing{faces, setting, dimensions_of(faces, setting), window_of(faces), {}, {}};
  drawing.sheet = lay_out(drawing, options);
  drop_illegible(drawing.dimensions, drawing.sheet);
  drawing.sheet = lay_out(drawing, options);  // the room of what was dropped is free
  const Box_mm& box = drawing.sheet.view;
  drawing.on_paper = {drawing.sheet.mm_of(1), {box.x, box.bottom()}, drawing.window.low};
  return draw_elevation(drawing);
}

}  // namespace jalon
