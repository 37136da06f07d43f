// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/setting_rows.h"
#include "base/text_number.h"
#include "model/part_classes.h"
#include "report/charts/residual_chart.h"
#include "report/elevation/view.h"
#include "report/names/notes.h"
#include "report/names/orientation_name.h"
#include "report/pages/coded_report.h"
#include "report/pages/facade_view.h"
#include "report/pages/html_frame.h"
#include "report/pages/html_model.h"
#include "report/pictures/ortho_files.h"
#include "report/pictures/picture.h"
#include "report/report.h"
#include "report/viewer/view_page.h"

namespace jalon {

namespace {

constexpr auto kReportRows = setting_rows(
    integer_row<&ReportSettings::bins>("bins", 5, 400, "1", "", "Bins of the residual histogram"),
    bool_row<&ReportSettings::drawing>("drawing", "",
                                       "With the elevation drawing, when there is a model"),
    bool_row<&ReportSettings::picture>(
        "picture", "", "With a front view of the points in the colours of their segments"),
    bool_row<&ReportSettings::orthoimage>(
        "orthoimage", "", "With an orthoimage of each facade, when there is a model"),
    integer_row<&ReportSettings::viewer_points>("viewer_points", 0, 1e9, "points", "",
                                                kViewerPointsHelp));

constexpr size_t kMostDrawings = 24;  // of single facades: a page that still opens at once

uint64_t labelled(const Segmentation& segmentation) {
  uint64_t n = 0;
  for (const auto& segment : segmentation.segments) n += segment.point_count();
  return n;
}

// "1 shop front", "2 recesses"; openings of no class are "other".
std::string counted(size_t n, std::string_view word) {
  std::string one(word == part_class::kOpening ? "other opening" : word);
  std::replace(one.begin(), one.end(), '_', ' ');
  const char* plural = n == 1 ? "" : one.ends_with('s') ? "es" : "s";
  return std::to_string(n) + " " + one + plural;
}

// " The model has 118 faces, 19 windows, 2 doors, 1 gateway and 0 other openings."
std::string model_text(const Model& model, const OpeningList& openings) {
  if (model.faces.empty()) return "";
  std::string text = " The model has " + counted(model.faces.size(), "face");
  if (openings.rows.empty()) return text + ".";
  for (const char* word : part_class::kOpenings) {
    const size_t n = count_of(openings, word);
    const bool is_last = word == std::string_view(part_class::kOpening);
    const bool is_usual = is_last || word == std::string_view(part_class::kWindow) ||
                          word == std::string_view(part_class::kDoor);
    if (n > 0 || is_usual) text += (is_last ? " and " : ", ") + counted(n, word);
  }
  return text + ".";
}

void add_summary(Page& page, const Segmentation& segmentation, const Notes& notes,
                 const Residuals& residuals, const std::string& model_text) {
  auto& html = page.html();
  html.open("h1").element("bdi", {}, notes.title).close();
  const uint64_t points = segmentation.cloud->size();
  const uint64_t used = residuals.count != 0 ? residuals.count : labelled(segmentation);
  const double share =
      points != 0 ? 100 * static_cast<double>(used) / static_cast<double>(points) : 0;
  const size_t planes = plane_count(segmentation.segments),
               curved = segmentation.segments.size() - planes;
  const std::string found =
      std::to_string(planes) + " planes" +
      (curved != 0 ? " and " + std::to_string(curved) + " spheres and cylinders" : "");
  html.element("p", {{"class", "lead"}},
               found + " from " + std::to_string(points) + " points; " + text_of(share, 1) +
                   " % of the points lie on them, with a standard deviation of " +
                   text_of(1000 * residuals.sigma_m, 2) + " mm." + model_text);
}

void add_input(Page& page, const Segmentation& segmentation, const Notes& notes) {
  page.heading("Input");
  auto pairs = notes.input;
  pairs.emplace_back("points", std::to_string(segmentation.cloud->size()));
  if (!segmentation.cloud->crs.empty())
    pairs.emplace_back("coordinate system", segmentation.cloud->crs);
  add_pairs(page, pairs);
}

void add_planes(Page& page, const Segmentation& segmentation, Task& task) {
  page.heading("Planes");
  auto& html = page.html();
  if (plane_count(segmentation.segments) == 0) return page.note("No plane was found.");
  page.open_table({"No", "orientation", "size (m)", "area (m\xC2\xB2)", "normal", "offset (m)",
                   "\xCF\x83 (mm)", "points"});
  for (size_t i = 0; i < segmentation.segments.size(); ++i) {
    if (i % 256 == 0) task.checkpoint(0);
    const Segment& s = segmentation.segments[i];
    if (!s.is_plane()) continue;
    const Vec3& n = s.fit.plane.normal;
    html.open("tr");
    page.number(std::to_string(s.label));
    html.element("td", {}, orientation_name(s.orientation));
    page.number(text_of(s.length_u_m, 2) + " x " + text_of(s.length_v_m, 2));
    page.number(text_of(s.area_m2, 2));
    page.number(text_of(n.x, 5) + ", " + text_of(n.y, 5) + ", " + text_of(n.z, 5));
    page.number(text_of(s.fit.plane.offset, 4));
    page.number(text_of(1000 * s.fit.sigma, 2));
    page.number(std::to_string(s.fit.n));
    html.close();
  }
  page.close_table();
  page.note(
      "normal . p = offset for a point p of the plane. Orientation is relative to the main facade. "
      "\xCF\x83 is the standard "
      "deviation of the points from their plane.");
}

void add_curved(Page& page, const Segmentation& segmentation, Task& task) {
  if (plane_count(segmentation.segments) == segmentation.segments.size()) return;
  page.heading("Spheres and cylinders");
  auto& html = page.html();
  page.open_table({"No", "type", "radius (m)", "\xCF\x83 radius (mm)", "centre or axis point (m)",
                   "axis", "length (m)", "area (m\xC2\xB2)", "\xCF\x83 (mm)", "points"});
  for (size_t i = 0; i < segmentation.segments.size(); ++i) {
    if (i % 256 == 0) task.checkpoint(0);
    const Segment& s = segmentation.segments[i];
    if (s.is_plane()) continue;
    const bool sphere = s.type == PrimitiveType::kSphere;
    const Vec3 place = sphere ? s.sphere.sphere.centre : s.cylinder.cylinder.point;
    const Vec3 axis = s.cylinder.cylinder.direction;
    html.open("tr");
    page.number(std::to_string(s.label));
    html.element("td", {}, sphere ? "sphere" : "cylinder");
    page.number(text_of(sphere ? s.sphere.sphere.radius : s.cylinder.cylinder.radius, 4));
    page.number(
        text_of(1000 * std::sqrt(sphere ? s.sphere.covariance[15] : s.cylinder.covariance[48]), 2));
    page.number(text_of(place.x, 3) + ", " + text_of(place.y, 3) + ", " + text_of(place.z, 3));
    page.number(
        sphere ? "" : text_of(axis.x, 5) + ", " + text_of(axis.y, 5) + ", " + text_of(axis.z, 5));
    page.number(sphere ? "" : text_of(s.length_u_m, 2));
    page.number(text_of(s.area_m2, 2));
    page.number(text_of(1000 * s.sigma_m(), 2));
    page.number(std::to_string(s.point_count()));
    html.close();
  }
  page.close_table();
  page.note(
      "The axis point is the one at mid height. \xCF\x83 radius is the standard deviation of the "
      "radius, "
      "\xCF\x83 that of the points from their surface.");
}

// The whole model, then each facade alone where there are several.
void add_drawings(Page& page, const Segmentation& segmentation, const Model& model,
                  const Notes& notes, Task& task) {
  const size_t facades = std::min(facade_parts(model).size(), kMostDrawings);
  page.heading(facades > 1 ? "Elevations" : "Elevation");
  ElevationSettings settings;
  settings.title = notes.title;
  settings.outlines_only = true;
  page.html().raw(elevation_svg(segmentation, model, settings, task));
  for (size_t k = 1; facades > 1 && k <= facades; ++k) {
    settings.facade = static_cast<int64_t>(k);
    page.html().raw(elevation_svg(segmentation, model, settings, task));
  }
  page.note(
      "Numbers on planes are those of the table of planes, W1, D1 ... types of openings of their "
      "table. Drawings "
      "to scale for printing are the files elevation*.svg.");
}

void add_picture(Page& page, const Segmentation& segmentation, const LabelRaster& front,
                 Task& task) {
  page.heading("Labelled points");
  page.html().raw(picture_svg(segmentation, {}, front, task));
  page.note(
      "Front view, from the station side. Segments that meet have different colours; "
      "the numbers are those of the table of "
      "planes. Noise, in grey, is shown only where no segment lies.");
}

// Of each facade that has a front and points near it, in pixels that a page has room for.
void add_orthoimages(Page& page, const Segmentation& segmentation, const Model& model, Task& task) {
  const size_t facades = std::min(facade_parts(model).size(), kMostDrawings);
  const double most_pixels = kOrthoPagePixels / static_cast<double>(std::max<size_t>(facades, 1));
  std::vector<std::string> figures;
  for (size_t k = facades > 1 ? 1 : 0; k <= (facades > 1 ? facades : 0); ++k) {
    OrthoimageSettings settings;
    settings.facade = static_cast<int64_t>(k);
    if (const auto image =
            find_orthoimage(*segmentation.cloud, model, settings, most_pixels, task)) {
      const std::string name = k == 0 ? "" : " of facade " + std::to_string(k);
      figures.push_back(orthoimage_svg(*image, "Orthoimage" + name, task));
    }
  }
  if (figures.empty()) return;
  page.heading(figures.size() > 1 ? "Orthoimages" : "Orthoimage");
  for (const std::string& figure : figures) page.html().raw(figure);
  page.note(
      "The points near the front plane of the facade in true scale, seen along its horizontal. "
      "Pixels without points have no data.");
}

void add_residuals(Page& page, const Residuals& r) {
  page.heading("Residuals");
  if (r.count == 0) return page.note("No point lies on a plane.");
  page.html().raw(residual_chart(r));
  page.note(std::to_string(r.count) + " points, mean " + text_of(1000 * r.mean_m, 3) +
            " mm, standard deviation " + text_of(1000 * r.sigma_m, 3) + " mm; " +
            std::to_string(r.below + r.above) + " points lie outside the range shown.");
}

}  // namespace

std::span<const ParamRow> report_rows() { return kReportRows; }

std::string report_html(const Segmentation& segmentation, const Model& model,
                        std::string_view notes_json, const ReportSettings& settings, Task& task) {
  if (!segmentation.notes_json.empty())
    return coded_report_html(segmentation, model, notes_json, settings, task);
  const ProgressSpan span(task, 0, 1, "writing the report");
  const Notes notes = read_notes(notes_json);
  const Residuals residuals =
      bin_residuals(segmentation, 0, static_cast<size_t>(settings.bins), task);
  Page page;
  open_page(page, notes.title);
  const OpeningList openings = list_openings(model, kTypeTolerance_m);
  add_summary(page, segmentation, notes, residuals, model_text(model, openings));
  if (settings.drawing && !model.faces.empty())
    add_drawings(page, segmentation, model, notes, task);
  if (settings.orthoimage && !model.faces.empty()) add_orthoimages(page, segmentation, model, task);
  LabelRaster front;  // for the picture and for the colours of the view
  if (settings.picture || settings.viewer_points > 0)
    front = rasterise_labels(segmentation, PictureView::kFront, task);
  if (settings.picture) add_picture(page, segmentation, front, task);
  if (settings.viewer_points > 0)
    add_viewer(page,
               facade_scene(segmentation, model, openings, residuals.half_range_m, front, task),
               settings.viewer_points, task);
  add_openings(page, model, openings);
  add_planes(page, segmentation, task);
  add_curved(page, segmentation, task);
  add_precision(page, segmentation, notes, task);
  add_parts(page, model);
  add_residuals(page, residuals);
  add_input(page, segmentation, notes);
  add_parameters(page, segmentation.parameters_json);
  add_times(page, notes);
  page.note("Written by Jalon.");
  return page.html().take();
}

}  // namespace jalon
