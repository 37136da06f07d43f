// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/coded_report.h"

#include <cmath>

#include "base/json_reader.h"
#include "base/json_writer.h"
#include "base/text_number.h"
#include "report/elevation/opening_list.h"
#include "report/pages/facade_view.h"
#include "report/pages/html_frame.h"
#include "report/pages/html_model.h"
#include "report/pictures/code_plan.h"
#include "report/sheet/svg_parts.h"
#include "report/viewer/view_page.h"
#include "segment/codes/notes_reader.h"

namespace jalon {

namespace {

constexpr double kResidualRange_m = 0.05;  // of the view: the text's thresholds are 2 to 6 cm
constexpr size_t kMostSurveyedTold = 6;    // of an object, in a cell of the table

std::string share_text(uint64_t part, uint64_t whole) {
  return whole == 0
             ? ""
             : text_of(100.0 * static_cast<double>(part) / static_cast<double>(whole), 2) + " %";
}

void add_lead(Page& page, const Segmentation& segmentation, const CodedNotes& notes,
              const Notes& told) {
  uint64_t classified = 0, with_points = 0;
  for (const NotedObject& o : notes.objects) {
    classified += o.points;
    with_points += o.points > 0;
  }
  page.html().open("h1").element("bdi", {}, told.title).close();
  page.html().element(
      "p", {{"class", "lead"}},
      grouped(notes.objects.size()) + " coded objects by method " + notes.method + ", " +
          grouped(with_points) + " of them with points; " + grouped(classified) + " of " +
          grouped(segmentation.cloud->size()) + " points (" +
          share_text(classified, segmentation.cloud->size()) + ") belong to one. " +
          (notes.warnings.empty() ? "No warnings."
                                  : grouped(notes.warnings.size()) + " warnings, listed below."));
}

void add_classes(Page& page, const Segmentation& segmentation, const CodedNotes& notes) {
  page.heading("Classes");
  page.open_table({"class", "points", "share"});
  for (const NotedClass& c : notes.classes) {
    page.html().open("tr");
    page.number(std::to_string(c.class_code));
    page.number(grouped(c.points));
    page.number(share_text(c.points, segmentation.cloud->size()));
    page.html().close();
  }
  page.close_table();
  page.note("Numbers of the field \"classification\", as written to the cloud.");
}

// "2.01 x 1.17 m", "r 0.038 m, 2.85 m long".
std::string size_text(const NotedObject& o) {
  if (o.shape == "prism")
    return grouped(o.outline.size()) + " corners" +
           (std::isfinite(o.low_m) ? ", " + text_of(o.high_m - o.low_m, 2) + " m high" : "");
  if (o.shape == "cylinder") {
    double length = 0;
    for (size_t i = 0; i + 1 < o.axis.size(); ++i) length += norm(o.axis[i + 1] - o.axis[i]);
    return "r " + text_of(o.radius_m, 3) + " m, " + text_of(length, 2) + " m long";
  }
  double width = 0;
  for (const Vec3& p : o.outline)
    for (const Vec3& q : o.outline) width = std::max(width, std::hypot(p.x - q.x, p.y - q.y));
  return o.outline.empty() ? "" : text_of(width, 2) + " x " + text_of(o.high_m - o.low_m, 2) + " m";
}

std::string surveyed_text(const NotedObject& o) {
  std::string text;
  for (size_t i = 0; i < std::min(o.surveyed.size(), kMostSurveyedTold); ++i)
    text += (i == 0 ? "" : ", ") + o.surveyed[i].id + " (" + o.surveyed[i].code + ")";
  if (o.surveyed.size() > kMostSurveyedTold)
    text += " and " + std::to_string(o.surveyed.size() - kMostSurveyedTold) + " more";
  return text;
}

void add_objects(Page& page, const CodedNotes& notes, Task& task) {
  page.heading("Coded objects");
  page.open_table({"No", "name", "code", "class", "shape", "size", "hinge", "points", "segment",
                   "surveyed points (code)"});
  for (size_t i = 0; i < notes.objects.size(); ++i) {
    if (i % 256 == 0) task.checkpoint(0);
    const NotedObject& o = notes.objects[i];
    page.html().open("tr");
    page.number(std::to_string(i + 1));
    page.foreign("td", o.name);
    page.number(std::to_string(o.code));
    page.number(std::to_string(o.class_code));
    page.html().element("td", {}, o.shape == "none" ? o.geometry : o.shape);
    page.number(size_text(o));
    page.html().element("td", {}, o.hinge);
    page.number(grouped(o.points));
    page.number(o.label == 0 ? "" : std::to_string(o.label));
    page.foreign("td", surveyed_text(o));
    page.html().close();
  }
  page.close_table();
}

void add_warnings(Page& page, const CodedNotes& notes) {
  page.heading("Warnings");
  if (notes.warnings.empty()) return page.note("None.");
  page.open_table({"line", "object", "warning"});
  for (const CodeWarning& w : notes.warnings) {
    page.html().open("tr");
    page.number(std::to_string(w.line));
    page.foreign("td", w.object);
    page.foreign("td", w.text);
    page.html().close();
  }
  page.close_table();
}

// Without the lists that the objects were read from.
void add_thresholds(Page& page, const std::string& json) {
  if (json.empty()) return;
  std::vector<std::pair<std::string, std::string>> pairs;
  const std::vector<JsonValue> parameters = read_json(json);
  for (const JsonValue& value : JsonChildren(parameters.front()))
    if (value.name != "codes" && value.name != "table")
      pairs.emplace_back(value.name, value.kind == JsonValue::Kind::kText
                                         ? value.text
                                         : JsonWriter().value(value).take());
  page.heading("Parameters");
  add_pairs(page, pairs);
}

}  // namespace

std::string coded_report_html(const Segmentation& segmentation, const Model& model,
                              std::string_view notes_json, const ReportSettings& settings,
                              Task& task) {
  const ProgressSpan span(task, 0, 1, "writing the report");
  const Notes told = read_notes(notes_json);
  const CodedNotes notes = read_coded_notes(segmentation.notes_json);
  Page page;
  open_page(page, told.title);
  add_lead(page, segmentation, notes, told);
  if (settings.picture) {
    page.heading("Plan");
    page.html().raw(code_plan_svg(segmentation, notes, told.title, task));
    page.note(
        "Where points lie above each other the plan shows the highest class. Surveyed points have "
        "their codes where there is room; the table of objects has all of them.");
  }
  if (settings.viewer_points > 0)
    add_viewer(page,
               facade_scene(segmentation, model, list_openings(model, kTypeTolerance_m),
                            kResidualRange_m, task),
               settings.viewer_points, task);
  add_warnings(page, notes);
  add_classes(page, segmentation, notes);
  add_objects(page, notes, task);
  auto pairs = told.input;
  pairs.emplace_back("points", std::to_string(segmentation.cloud->size()));
  if (!segmentation.cloud->crs.empty())
    pairs.emplace_back("coordinate system", segmentation.cloud->crs);
  page.heading("Input");
  add_pairs(page, pairs);
  add_thresholds(page, segmentation.parameters_json);
  add_times(page, told);
  page.note("Written by Jalon.");
  return page.html().take();
}

}  // namespace jalon
