// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "report/elevation.h"
#include "report/report.h"

namespace jalon {

namespace {

constexpr ParamRow kElevationRows[] = {
    string_row("title", "Facade elevation", "", "Title of the drawing"),
    choice_row("paper", "auto", "auto|A4|A3|A2|A1|A0", "",
               "Paper, landscape; auto = A3, or A4 where it holds the same scale"),
    integer_row("scale", 0, 0, 1e9, "1", "",
                "Denominator of the scale (100 = 1:100); 0 = the largest usual one that fits"),
    number_row("in_front_m", 10, 0, 1e6, "m", "",
               "Faces further than this (a depth) in front of the main plane are left out"),
    number_row("behind_m", 10, 0, 1e6, "m", "", "Faces further than this (a depth) behind the main plane are left out"),
    number_row("front_angle_rad", 0.26, 0, 0.8, "rad", "",
               "Faces turned from the facade by less than this are filled by depth"),
    bool_row("labels", true, "", "Plane numbers on the faces"),
    bool_row("dimensions", true, "", "Overall width and height"),
    bool_row("outlines_only", false, "", "Without border and title block: a figure for another page"),
};

}  // namespace

std::span<const ParamRow> elevation_rows() { return kElevationRows; }

std::string elevation_svg(const Segmentation& segmentation, const Model& model, const ParamSet& options, Task& task) {
  const Span span(task, 0, 1, "drawing the elevation");
  const ViewLimits limits{options.number("in_front_m"), options.number("behind_m"), options.number("front_angle_rad")};
  const ElevationFaces faces = elevation_faces(segmentation, model, limits, task);
  ElevationSetting setting;
  setting.title = options.text("title");
  setting.is_sheet = !options.flag("outlines_only");
  setting.labels = options.flag("labels");
  setting.dimensions = options.flag("dimensions");
  setting.points = segmentation.cloud->size();
  setting.planes = plane_count(segmentation.segments);
  const auto& m = segmentation.T_facade_world.m;
  setting.view_azimuth_rad = std::atan2(m[4], m[5]);  // the facade's +Y in the world: away from the eye
  const Window window = window_of(faces);
  const Sheet sheet = setting.is_sheet
                          ? lay_out_sheet(window.width(), window.height(), options.text("paper"),
                                          options.integer("scale"))
                          : lay_out_figure(window.width(), window.height());
  return draw_elevation(faces, sheet, setting);
}

}  // namespace jalon
