// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/setting_rows.h"
#include "formats/units/crs_code.h"
#include "report/elevation/elevation.h"
#include "report/elevation/legend.h"
#include "report/report.h"

namespace jalon {

namespace {

using S = ElevationSettings;

constexpr auto kLimitRows = setting_rows(
    number_row<&ViewLimits::in_front_m>(
        "in_front_m", 0, 1e6, "m", "",
        "Faces further than this (a depth) in front of the main plane are left out"),
    number_row<&ViewLimits::behind_m>(
        "behind_m", 0, 1e6, "m", "",
        "Faces further than this (a depth) behind the main plane are left out"),
    number_row<&ViewLimits::element_reach_m>(
        "element_reach_m", 0, 1e6, "m", "",
        "Elements that stand further than this (a depth) in front of every wall are left out: "
        "cars, trees"),
    number_row<&ViewLimits::front_angle_rad>(
        "front_angle_rad", 0, 0.8, "rad", "",
        "Faces turned from the facade by less than this are filled by depth"));

constexpr auto kElevationRows = setting_rows(
    string_row<&S::title>("title", "", "Title of the drawing"),
    string_row<&S::source>("source", "",
                           "What the drawing was made from, for the title block; empty = left out"),
    string_row<&S::date>("date", "", "Date for the title block; empty = left out"),
    choice_row<&S::paper>(
        "paper", "auto|A4|A3|A2|A1|A0", "",
        "Paper, landscape, or upright from A3 on where that fits better; auto = A3, or A4 where it "
        "holds the same scale"),
    integer_row<&S::scale>(
        "scale", 0, 1e9, "1", "",
        "Denominator of the scale (100 = 1:100); 0 = the largest usual one that fits"),
    integer_row<&S::facade>(
        "facade", 0, 1e9, "1", "",
        "0 = the whole model from the front of its main facade; k = its k-th facade alone, from "
        "its own front"),
    nested_rows<&S::limits, kLimitRows>(),
    choice_row<&S::colours>(
        "colours", "sides|depth|none", "",
        "sides: red in front of the main plane, green behind it; depth: one scale from near to "
        "far; none: lines alone"),
    number_row<&S::type_tolerance_m>(
        "type_tolerance_m", 0, 10, "m", "",
        "Openings whose width and height agree within this are of one type"),
    bool_row<&S::labels>(
        "labels", "", "Types of the openings on them; plane numbers where no opening has a name"),
    bool_row<&S::dimensions>("dimensions", "", "Chains of dimensions and height marks"),
    bool_row<&S::outlines_only>("outlines_only", "",
                                "Without border and title block: a figure for another page"));

ElevationContent content_of(const Segmentation& segmentation, const ElevationView& view,
                            const ElevationSettings& settings) {
  ElevationContent out;
  static_cast<ElevationSettings&>(out) = settings;
  if (!view.name.empty()) out.title += ": " + view.name;
  out.id = settings.facade == 0 ? "" : "-" + std::to_string(settings.facade);
  out.points = segmentation.cloud->size();
  out.planes = plane_count(segmentation.segments);
  out.has_north = !segmentation.cloud->crs.empty() && !is_local_crs(segmentation.cloud->crs.str());
  out.view_azimuth_rad = view.azimuth_rad();
  return out;
}

Sheet lay_out(const ElevationDrawing& drawing) {
  const Window& window = drawing.window;
  const ElevationContent& content = drawing.content;
  const Margins_mm margins = margins_for(drawing.dimensions);
  if (!content.outlines_only)
    return lay_out_sheet(window.width(), window.height(), content.paper, content.scale, margins);
  return lay_out_figure(window.width(), window.height(), margins,
                        legend_height(legend_items(drawing.faces, content)));
}

}  // namespace

std::span<const ParamRow> elevation_rows() { return kElevationRows; }

std::string elevation_svg(const Segmentation& segmentation, const Model& model,
                          const ElevationSettings& settings, Task& task) {
  const ProgressSpan span(task, 0, 1, "drawing the elevation");
  OpeningList openings = list_openings(model, settings.type_tolerance_m);
  const ElevationView view = elevation_view(segmentation, model, settings.facade);
  const ElevationContent content = content_of(segmentation, view, settings);
  ElevationFaces faces = elevation_faces(model, view, settings.limits, task);
  faces.list = std::move(openings);
  add_openings(faces, model, view);
  ElevationDrawing drawing{faces, content, dimensions_of(faces, content), window_of(faces), {}, {}};
  drawing.sheet = lay_out(drawing);
  drop_illegible(drawing.dimensions, drawing.sheet);
  drawing.sheet = lay_out(drawing);  // the room of what was dropped is free
  const Box_mm& box = drawing.sheet.view;
  drawing.on_paper = {drawing.sheet.mm_of(1), {box.x, box.bottom()}, drawing.window.low};
  return draw_elevation(drawing);
}

}  // namespace jalon
