// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/clearance_report.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/setting_rows.h"
#include "base/text_number.h"
#include "compare/distance/model_sample.h"
#include "report/charts/clearance_chart.h"
#include "report/charts/clearance_section.h"
#include "report/pages/clearance_view.h"
#include "report/pages/html_frame.h"
#include "report/pages/html_model.h"
#include "report/sheet/svg_parts.h"
#include "report/viewer/view_page.h"

namespace jalon {

namespace {

constexpr size_t kMostTight = 40;  // rows of the table: more are in places.csv

constexpr auto kClearanceReportRows =
    setting_rows(number_row<&ClearanceReportSettings::margin_m>(
                     "margin_m", 0, 1000, "m", "",
                     "Margin of the sweep: the dashed line, and the ends of the colours"),
                 number_row<&ClearanceReportSettings::apart_m>(
                     "apart_m", 0, 1e6, "m", "",
                     "One tight place stands for all obstacles within this distance of it"),
                 integer_row<&ClearanceReportSettings::sections>(
                     "sections", 0, 40, "1", "", "Sections, at the tightest places"),
                 integer_row<&ClearanceReportSettings::viewer_points>(
                     "viewer_points", 0, 1e9, "points", "", kViewerPointsHelp));

struct SweepColumn {
  const char* name;
  ElementType type;
  uint32_t components;
};

// Tables come from outside: only those of a sweep have these columns.
void require_sweep_table(const FieldTable& table, const char* name) {
  constexpr SweepColumn kColumns[] = {
      {"parameter", ElementType::kFloat64, 1}, {"clearance", ElementType::kFloat64, 1},
      {"piece", ElementType::kUint32, 1},      {"kind", ElementType::kUint8, 1},
      {"point", ElementType::kUint64, 1},      {"triangle", ElementType::kUint64, 1},
      {"xyz", ElementType::kFloat64, 3},       {"gauge_xyz", ElementType::kFloat64, 3}};
  for (const SweepColumn& wanted : kColumns) {
    const Column* column = table.find(wanted.name);
    if (column == nullptr || column->info().type != wanted.type ||
        column->info().components != wanted.components || column->count() != table.at(0)->count())
      fail(Status::kInvalidArgument,
           "%s is no table of jalon_gauge_sweep: column \"%s\" is not as there", name, wanted.name);
  }
}

size_t count_up_to(const Column& clearance, double limit_m) {
  size_t count = 0;
  for (size_t i = 0; i < clearance.count(); ++i) count += clearance.number(i) <= limit_m;
  return count;
}

std::string outcome_of(const GaugeRun& run, const GaugePath& path, double margin_m) {
  const Column& clearance = run.intervals.require("clearance");
  size_t least = clearance.count();
  for (size_t i = 0; i < clearance.count(); ++i)
    if (std::isfinite(clearance.number(i)) &&
        (least == clearance.count() || clearance.number(i) < clearance.number(least)))
      least = i;
  if (least == clearance.count()) return "Nothing comes near the gauge on its way.";
  const double value = clearance.number(least),
               at = run.intervals.require("parameter").number(least);
  return (value <= 0 ? "The gauge meets an obstacle, " + text_of(-value, 3) + " m deep, "
                     : "The least clearance is " + text_of(value, 3) + " m, ") +
         "after " + text_of(path.chainage_m(at), 2) + " m of its way. Of " +
         grouped(clearance.count()) + " intervals between poses " +
         grouped(count_up_to(clearance, margin_m)) + " are within the margin of " +
         text_of(margin_m, 3) + " m, " + grouped(count_up_to(clearance, 0)) + " touch.";
}

std::string obstacle_of(const FieldTable& places, size_t row) {
  const bool is_point = places.require("kind").number(row) == 1;
  const uint64_t number = places.require(is_point ? "point" : "triangle").values<uint64_t>()[row];
  return (is_point ? "point " : "triangle ") + std::to_string(number);
}

void add_tight_table(Page& page, const GaugeRun& run, std::span<const TightPlace> tight,
                     double apart_m) {
  page.heading("Tight places");
  if (tight.empty()) {
    page.note("Nothing comes within the margin.");
    return;
  }
  page.open_table({"Place", "Clearance (m)", "Way (m)", "Pose", "Right (m)", "Above (m)", "x", "y",
                   "z", "Obstacle", "Piece"});
  for (size_t i = 0; i < tight.size(); ++i) {
    const TightPlace& place = tight[i];
    page.html().open("tr");
    page.number(std::to_string(i + 1));
    page.number(text_of(place.clearance_m, 4));
    page.number(text_of(place.chainage_m, 2));
    page.number(text_of(place.parameter, 2));
    page.number(text_of(place.in_section.x, 3));
    page.number(text_of(place.in_section.y, 3));
    for (int axis = 0; axis < 3; ++axis) page.number(text_of(place.obstacle[axis], 3));
    page.html().element("td", {}, obstacle_of(run.places, place.row));
    page.number(text_of(run.places.require("piece").number(place.row)));
    page.html().close();
  }
  page.close_table();
  page.note("Each is the tightest of the " + grouped(run.places.require("clearance").count()) +
            " obstacles within the margin that lie nearer than " + text_of(apart_m, 2) +
            " m to it. Right and above are from the gauge's origin, seen along its travel; "
            "negative clearances are "
            "depths inside.");
}

void add_sections(Page& page, const GaugeRun& run, const GaugePath& path,
                  std::span<const TightPlace> tight, const PartTriangles* surface, int64_t most,
                  Task& task) {
  const size_t count = std::min(tight.size(), static_cast<size_t>(most));
  if (count == 0) return;
  page.heading("Sections at the tight places");
  page.html().open("div", {{"style", "display:flex;flex-wrap:wrap;gap:1rem"}});
  for (size_t i = 0; i < count; ++i) {
    page.html()
        .open("div")
        .raw(clearance_section(tight[i], i + 1, path, run.gauge, run.cloud.get(), surface))
        .close();
    task.checkpoint(static_cast<double>(i + 1) / static_cast<double>(count));
  }
  page.html().close();
  if (!run.gauge.empty())
    page.note(std::string("Blue: the outline of each piece of the gauge, seen along the travel. ") +
              (surface != nullptr ? "Black: the model, cut. " : "") +
              "Red: from the obstacle to the nearest point of the gauge; it may lean out of the "
              "section.");
}

bool has_surface(const Model* model) {
  return model != nullptr && !(model->faces.empty() && model->triangles.empty());
}

std::optional<PartTriangles> surface_of(const Model* model) {
  if (!has_surface(model)) return std::nullopt;
  return triangles_of_part(*model, kWholeModel, kDrawnChord_m);
}

// What the view shows of a model.
CloudPtr points_on(const Model* model, int64_t viewer_points, Task& task) {
  constexpr int64_t kMostOnModel = 300000;
  if (!has_surface(model) || viewer_points == 0) return nullptr;
  ModelSampleSettings settings;
  settings.points = static_cast<uint64_t>(std::min(viewer_points, kMostOnModel));
  settings.chord_error_m = kDrawnChord_m;
  return std::make_shared<const Cloud>(sample_model(*model, settings, task));
}

}  // namespace

std::span<const ParamRow> clearance_report_rows() { return kClearanceReportRows; }

std::string clearance_html(const GaugeRun& run, std::string_view notes_json,
                           const ClearanceReportSettings& settings, Task& task) {
  const ProgressSpan span(task, 0, 1, "writing the report");
  const Notes notes = read_notes(notes_json);
  require_sweep_table(run.places, "places");
  require_sweep_table(run.intervals, "intervals");
  const GaugePath path(run.poses);
  const std::vector<TightPlace> tight =
      tight_places(run.places, path, settings.apart_m, kMostTight);
  Page page;
  open_page(page, notes.title);
  page.html().open("h1").element("bdi", {}, notes.title).close();
  page.html().element("p", {{"class", "lead"}}, outcome_of(run, path, settings.margin_m));
  if (const std::string chart = clearance_chart(run.intervals, path, tight, settings.margin_m);
      !chart.empty()) {
    page.heading("Clearance along the way");
    page.html().raw(chart);
    page.note(
        "The least of each interval between poses: red touches, orange is within the margin "
        "(dashed), green is "
        "free; blank: nothing within reach. Numbers are those of the tight places.");
  }
  add_tight_table(page, run, tight, settings.apart_m);
  const std::optional<PartTriangles> surface = surface_of(run.model.get());
  add_sections(page, run, path, tight, surface ? &*surface : nullptr, settings.sections, task);
  add_viewer(page,
             clearance_scene(run.cloud, points_on(run.model.get(), settings.viewer_points, task),
                             run.places, path, tight, settings.margin_m),
             settings.viewer_points, task);
  if (!notes.input.empty()) {
    page.heading("Input");
    add_pairs(page, notes.input);
  }
  add_times(page, notes);
  page.note("Written by Jalon.");
  return page.html().take();
}

}  // namespace jalon
