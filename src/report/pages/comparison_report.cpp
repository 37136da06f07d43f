// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/comparison_report.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/setting_rows.h"
#include "base/text_number.h"
#include "report/charts/distance_chart.h"
#include "report/pages/html_frame.h"
#include "report/pages/html_model.h"
#include "report/pages/comparison_view.h"
#include "report/pictures/deviation_picture.h"
#include "report/sheet/svg_parts.h"
#include "report/viewer/view_page.h"

namespace jalon {

namespace {

constexpr auto kComparisonReportRows = setting_rows(
    integer_row<&ComparisonReportSettings::bins>("bins", 5, 400, "1", "", "Bins of the histograms"),
    number_row<&ComparisonReportSettings::threshold_m>(
        "threshold_m", 0, 1e9, "m", "",
        "Distance marked in the histograms, up to which they are noise; 0 = none"),
    number_row<&ComparisonReportSettings::limit_m>(
        "limit_m", 0, 1e9, "m", "", "Distance at the end of the colour scale; 0 = 98 % lie within"),
    bool_row<&ComparisonReportSettings::picture>("picture", "", "With the pictures of the points"),
    integer_row<&ComparisonReportSettings::viewer_points>("viewer_points", 0, 1e9, "points", "",
                                                          kViewerPointsHelp));

constexpr size_t kMostRows = 500;  // of changes in the page; the CSV has them all
constexpr const char* kClasses[] = {"",
                                    "appearance",
                                    "disappearance",
                                    "displacement",
                                    "displacement with overlap",
                                    "deformation",
                                    "deformation with overlap"};
constexpr const char* kComparisonReportSideBySide =
    "display:grid;grid-template-columns:repeat(auto-fit,minmax(26rem,1fr));gap:1rem";

std::string mm(double metres) { return std::isfinite(metres) ? text_of(1000 * metres, 2) : "-"; }
std::string metres_of_comparison_report(double value, int decimals = 3) {
  return std::isfinite(value) ? text_of(value, decimals) : "-";
}

std::vector<double> finite_distances(const Comparison& comparison) {
  std::vector<double> out;
  for (const double d : comparison.points.require("distance").values<double>())
    if (std::isfinite(d)) out.push_back(d);
  return out;
}

struct Fitted {
  Histogram histogram;
  std::optional<NoiseLaw> law;  ///< none where the distances do not scatter
};

// The law is that of the distances below the threshold: what has changed is no noise.
Fitted fit(const Comparison& comparison, const DeviationScale& scale, double threshold_m,
           int64_t bins, Task& task) {
  Fitted out;
  const std::vector<double> values = finite_distances(comparison);
  std::vector<double> quiet;
  for (const double d : values)
    if (!(threshold_m > 0) || std::abs(d) <= threshold_m) quiet.push_back(d);
  using Law = NoiseLawSettings::Law;
  const Law kind = scale.is_signed ? Law::kGauss : Law::kWeibull;
  try {
    out.law = fit_noise_law(quiet, {.law = kind}, task);
  } catch (const Error& error) {  // too few values, or all the same: a histogram without a curve
    if (error.status() != Status::kInsufficientData && error.status() != Status::kDegenerate) throw;
  }
  const HistogramSettings bounds{
      .bins = static_cast<uint64_t>(bins), .minimum = scale.lowest_m(), .maximum = scale.limit_m};
  if (!values.empty())
    out.histogram = field_histogram(values, out.law ? &*out.law : nullptr, bounds, task);
  return out;
}

void add_summary(Page& page, const Comparison& forward, const Comparison* reverse) {
  page.heading("Summary");
  auto& html = page.html();
  page.open_table({"direction", "points", "compared", "hidden", "out of range", "out of field",
                   "nothing near", "mean (mm)", "rms (mm)", "\xCF\x83 (mm)", "least (m)",
                   "largest (m)"});
  const auto row = [&](const char* name, const Comparison& c) {
    html.open("tr");
    html.element("td", {}, name);
    for (const char* count :
         {"points", "compared", "hidden", "out_of_range", "out_of_field", "nothing_near"})
      page.number(grouped(static_cast<uint64_t>(c.summary.require(count).number(0))));
    for (const char* value : {"mean", "rms", "sigma"})
      page.number(mm(c.summary.require(value).number(0)));
    for (const char* value : {"minimum", "maximum"})
      page.number(metres_of_comparison_report(c.summary.require(value).number(0)));
    html.close();
  };
  row("compared with the reference", forward);
  if (reverse != nullptr) row("reference with the compared", *reverse);
  page.close_table();
  page.note("The largest of unsigned distances is the directed Hausdorff distance.");
}

// What else the method summed up: sampling error, levels of detection, tolerances ...
void add_more(Page& page, const Comparison& comparison) {
  constexpr const char* kTold[] = {"points",       "compared",     "hidden",         "out_of_range",
                                   "out_of_field", "nothing_near", "too_few_points", "mean",
                                   "rms",          "sigma",        "minimum",        "maximum"};
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const ColumnPtr& column : comparison.summary) {
    const FieldInfo& info = column->info();
    const bool is_told = std::any_of(std::begin(kTold), std::end(kTold),
                                     [&](const char* n) { return info.name == n; });
    if (is_told || info.components != 1 || column->count() != 1) continue;
    const bool in_mm = info.unit == "m";
    const double value = column->number(0);
    pairs.emplace_back(
        info.meaning.empty() ? info.name : info.name + ": " + info.meaning,
        is_floating(info.type)
            ? (in_mm ? mm(value) + " mm" : metres_of_comparison_report(value, 4) + " " + info.unit)
            : grouped(static_cast<uint64_t>(std::max(0.0, value))));
  }
  if (pairs.empty()) return;
  page.heading("Precision and detection");
  add_pairs(page, pairs);
}

std::string vector_text(const Column& column, size_t row, int decimals) {
  std::string out;
  for (uint32_t k = 0; k < column.info().components; ++k)
    out += (k > 0 ? ", " : "") + metres_of_comparison_report(column.number(row, k), decimals);
  return out;
}

void add_changes(Page& page, const FieldTable& changes) {
  const bool has_classes = changes.find("class") != nullptr;
  page.heading(has_classes ? "Changes" : "Change regions");
  const size_t rows = changes.size() == 0 ? 0 : changes.at(0)->count();
  if (rows == 0) return page.note("Nothing has changed by more than the threshold.");
  auto& html = page.html();
  if (has_classes)
    page.open_table({"No", "class", "confidence", "area before (m\xC2\xB2)",
                     "area after (m\xC2\xB2)", "volume before (m\xC2\xB3)",
                     "volume after (m\xC2\xB3)", "centroid before (m)", "centroid after (m)",
                     "displacement (m)", "its \xCF\x83 (mm)"});
  else
    page.open_table({"No", "points", "area (m\xC2\xB2)", "volume (m\xC2\xB3)", "mean (mm)",
                     "largest (mm)", "centroid (m)"});
  for (size_t i = 0; i < std::min(rows, kMostRows); ++i) {
    html.open("tr");
    page.number(std::to_string(i + 1));
    if (has_classes) {
      html.element(
          "td", {},
          kClasses[std::min<size_t>(6, static_cast<size_t>(changes.require("class").number(i)))]);
      page.number(text_of(changes.require("confidence").number(i), 2));
      for (const char* name : {"area_before", "area_after", "volume_before", "volume_after"})
        page.number(metres_of_comparison_report(changes.require(name).number(i)));
      for (const char* name : {"centroid_before", "centroid_after", "displacement"})
        page.number(vector_text(changes.require(name), i, 3));
      const Column& covariance = changes.require("covariance");
      std::string sigma;
      for (const uint32_t k : {21u, 28u, 35u})
        sigma += (k > 21 ? ", " : "") + mm(std::sqrt(covariance.number(i, k)));
      page.number(sigma);
    } else {
      page.number(grouped(static_cast<uint64_t>(changes.require("points").number(i))));
      for (const char* name : {"area", "volume"})
        page.number(metres_of_comparison_report(changes.require(name).number(i)));
      page.number(mm(changes.require("mean").number(i)));
      page.number(mm(changes.require("extreme").number(i)));
      page.number(vector_text(changes.require("centroid"), i, 2));
    }
    html.close();
  }
  page.close_table();
  if (rows > kMostRows)
    page.note("The first " + std::to_string(kMostRows) + " of " + std::to_string(rows) + ".");
}

void add_pictures(Page& page, const Comparison& forward, const Comparison* reverse,
                  const DeviationScale& scale, Task& task) {
  page.heading("Where");
  DeviationPictureSettings settings;
  page.html().open("div", {{"style", kComparisonReportSideBySide}});
  settings.title = "Compared with the reference";
  page.html().raw(deviation_svg(forward, scale, settings, task));
  if (reverse != nullptr) {
    settings.title = "Reference with the compared";
    page.html().raw(deviation_svg(*reverse, scale, settings, task));
  }
  page.html().close();
  page.note(
      "Points of the first-named cloud, coloured by their distance from the other; both on one "
      "scale.");
}

std::string histogram_of(const Comparison& comparison, const DeviationScale& scale,
                         const ComparisonReportSettings& settings, Task& task) {
  const double threshold_m = settings.threshold_m;
  const Fitted fitted = fit(comparison, scale, threshold_m, settings.bins, task);
  std::vector<ChartMark> marks;
  if (threshold_m > 0) marks.push_back({threshold_m, "threshold"});
  if (threshold_m > 0 && scale.is_signed) marks.push_back({-threshold_m, "threshold"});
  return distance_chart(fitted.histogram, fitted.law ? &*fitted.law : nullptr, marks);
}

void add_histograms(Page& page, const Comparison& forward, const Comparison* reverse,
                    const DeviationScale& scale, const ComparisonReportSettings& settings,
                    Task& task) {
  page.heading("How far");
  page.html().open("div", {{"style", kComparisonReportSideBySide}});
  for (const Comparison* comparison : {&forward, reverse})
    if (comparison != nullptr) page.html().raw(histogram_of(*comparison, scale, settings, task));
  page.html().close();
  page.note(
      "The curve is the noise law fitted to the distances below the threshold; what rises above it "
      "to the right "
      "is change. Distances beyond the colour scale are not drawn.");
}

}  // namespace

std::span<const ParamRow> comparison_report_rows() { return kComparisonReportRows; }

std::string comparison_html(const Comparison& forward, const Comparison* reverse,
                            const FieldTable& changes, std::string_view notes_json,
                            const ComparisonReportSettings& settings, Task& task) {
  const ProgressSpan span(task, 0, 1, "writing the report");
  const Notes notes = read_notes(notes_json);
  std::vector<const Comparison*> both{&forward};
  if (reverse != nullptr) both.push_back(reverse);
  const DeviationScale scale = deviation_scale(both, settings.limit_m);
  Page page;
  open_page(page, notes.title);
  page.html().open("h1").element("bdi", {}, notes.title).close();
  add_summary(page, forward, reverse);
  if (settings.picture) add_pictures(page, forward, reverse, scale, task);
  add_viewer(page, comparison_scene(forward, reverse, changes, scale), settings.viewer_points,
             task);
  add_histograms(page, forward, reverse, scale, settings, task);
  if (changes.size() > 0) add_changes(page, changes);
  add_more(page, forward);
  if (!notes.input.empty()) {
    page.heading("Input");
    add_pairs(page, notes.input);
  }
  add_parameters(page, forward.parameters_json);
  add_times(page, notes);
  page.note("Written by Jalon.");
  return page.html().take();
}

std::string comparison_histogram(const Comparison& comparison,
                                 const ComparisonReportSettings& settings, Task& task) {
  const Comparison* one[] = {&comparison};
  return histogram_of(comparison, deviation_scale(one, settings.limit_m), settings, task);
}

}  // namespace jalon
