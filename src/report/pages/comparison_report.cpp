// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/comparison_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/numbers.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "compare/landslide/cell_table.h"
#include "report/charts/distance_chart.h"
#include "report/names/told_numbers.h"
#include "report/pages/change_sections.h"
#include "report/pages/html_frame.h"
#include "report/pages/landslide_sections.h"
#include "report/pages/html_model.h"
#include "report/pages/comparison_view.h"
#include "report/pictures/deviation_picture.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"
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

constexpr size_t kMostMarks = 200;  // numbers on the maps: more would cover what they name
constexpr size_t kMostPages = 40;   // of changes, each with two pictures
constexpr const char* kComparisonReportSideBySide =
    "display:grid;grid-template-columns:repeat(auto-fit,minmax(26rem,1fr));gap:1rem";

std::vector<double> finite_distances(const Comparison& comparison) {
  const auto distances = comparison.points.require("distance").values<double>();
  std::vector<double> out;
  out.reserve(distances.size());
  for (const double d : distances)
    if (std::isfinite(d)) out.push_back(d);
  return out;
}

struct Fitted {
  Histogram histogram;
  std::optional<NoiseLaw> law;  ///< none where the distances do not scatter
  uint64_t law_values = 0;      ///< that it was fitted to
};

// The axis shows the body of the distances: so many standard deviations, robust ones, about their median.
constexpr double kBodySigmas = 6, kSigmaOfDeviation = 1.4826;

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Values that a curve is fitted to: its spread is known to 0.2 %, less than the width of its line.
constexpr size_t kMostOfCurve = 200000;

// The values up to noise_m in size, in their order; of more than kMostOfCurve evenly so many. count: of all of them.
std::vector<double> quiet_values(const std::vector<double>& values, double noise_m, size_t& count) {
  const auto is_quiet = [&](double d) { return std::abs(d) <= noise_m; };
  count = static_cast<size_t>(std::count_if(values.begin(), values.end(), is_quiet));
  std::vector<double> out;
  out.reserve(std::min(count, kMostOfCurve));
  size_t at = 0;
  for (const double d : values) {
    if (!is_quiet(d)) continue;
    const bool is_kept = count <= kMostOfCurve || at == out.size() * count / kMostOfCurve;
    if (is_kept && out.size() < kMostOfCurve) out.push_back(d);
    ++at;
  }
  return out;
}

// End of that axis, rounded up; no farther than the colour scale unless that was asked for.
double body_limit(std::vector<double> values, const DeviationScale& scale, double asked_m) {
  if (asked_m > 0 || values.empty()) return scale.limit_m;
  const double middle = median_of(values);
  for (double& d : values) d = std::abs(d - middle);
  const double reach = std::abs(middle) + kBodySigmas * kSigmaOfDeviation * median_of(values);
  return reach > 0 ? std::min(scale.limit_m, round_up_125(reach)) : scale.limit_m;
}

// The law is that of the distances below the threshold, or of the body: what has changed is no noise.
Fitted fit(const Comparison& comparison, const DeviationScale& scale,
           const ComparisonReportSettings& settings, Task& task) {
  Fitted out;
  const std::vector<double> values = finite_distances(comparison);
  const double limit_m = body_limit(values, scale, settings.limit_m);
  const double noise_m = settings.threshold_m > 0 ? settings.threshold_m : limit_m;
  size_t all_quiet = 0;
  const std::vector<double> quiet = quiet_values(values, noise_m, all_quiet);
  out.law_values = all_quiet;
  using Law = NoiseLawSettings::Law;
  const Law kind = scale.is_signed ? Law::kGauss : Law::kWeibull;
  try {
    out.law = fit_noise_law(quiet, {.law = kind}, task);
  } catch (const Error& error) {  // too few values, or all the same: a histogram without a curve
    if (error.status() != Status::kInsufficientData && error.status() != Status::kDegenerate) throw;
  }
  const HistogramSettings bounds{.bins = static_cast<uint64_t>(settings.bins),
                                 .minimum = scale.is_signed ? -limit_m : 0,
                                 .maximum = limit_m};
  if (!values.empty()) out.histogram = field_counts(values, bounds);
  return out;
}

// is_unsigned: all distances are to the nearest point or surface, without a sign.
void add_summary(Page& page, const Comparison& forward, const Comparison* reverse,
                 bool is_unsigned) {
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
      page.number(told_mm(c.summary.require(value).number(0)));
    for (const char* value : {"minimum", "maximum"})
      page.number(told_number(c.summary.require(value).number(0)));
    html.close();
  };
  row("compared with the reference", forward);
  if (reverse != nullptr) row("reference with the compared", *reverse);
  page.close_table();
  if (is_unsigned)
    page.note("The largest of these unsigned distances is the directed Hausdorff distance.");
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
    if (is_landslide(comparison) && is_told_of_landslide(info.name)) continue;
    const bool in_mm = info.unit == "m";
    const double value = column->number(0);
    // Of a bare number the unit is 1, which beside it would read as a digit.
    const std::string unit = info.unit.empty() || info.unit == "1" ? "" : " " + info.unit;
    pairs.emplace_back(info.meaning.empty() ? info.name : info.name + ": " + info.meaning,
                       is_floating(info.type)
                           ? (in_mm ? told_mm(value) + " mm" : told_number(value, 4) + unit)
                           : grouped(static_cast<uint64_t>(std::max(0.0, value))));
  }
  if (pairs.empty()) return;
  page.heading("Precision and detection");
  add_pairs(page, pairs);
}

// Of one direction.
struct Detection {
  uint64_t points = 0, tested = 0, significant = 0;
  std::array<double, 3> levels_m{kNaN, kNaN, kNaN};  ///< of detection, at kLevelShares
};
constexpr std::array kLevelShares{0.05, 0.5, 0.95};

bool has_detection(const Comparison* comparison) {
  return comparison != nullptr && comparison->points.find("level_of_detection") != nullptr &&
         comparison->points.find("significant") != nullptr;
}

Detection detection_of(const Comparison& comparison) {
  const Column &level = comparison.points.require("level_of_detection"),
               &significant = comparison.points.require("significant");
  Detection out{.points = level.count()};
  std::vector<double> levels;
  levels.reserve(level.count());
  for (size_t i = 0; i < level.count(); ++i) {
    if (significant.number(i) != 0) ++out.significant;
    if (const double at = level.number(i); at >= 0) levels.push_back(at);
  }
  out.tested = levels.size();
  if (levels.empty()) return out;
  for (size_t k = 0; k < kLevelShares.size(); ++k) {
    const auto at = levels.begin() + static_cast<std::ptrdiff_t>(
                                         kLevelShares[k] * static_cast<double>(levels.size() - 1));
    std::nth_element(levels.begin(), at, levels.end());
    out.levels_m[k] = *at;
  }
  return out;
}

// How far a distance must be to be one, and how many are.
void add_detection(Page& page, const Comparison& forward, const Comparison* reverse, Task& task) {
  if (!has_detection(&forward)) return;
  struct Row {
    const char* name;
    const Comparison* of;
    Detection found;
  };
  std::vector<Row> rows{{"compared with the reference", &forward, {}}};
  if (has_detection(reverse)) rows.push_back({"reference with the compared", reverse, {}});
  parallel_chunks(task, rows.size(), [&](size_t k) { rows[k].found = detection_of(*rows[k].of); });
  page.heading("Significance");
  auto& html = page.html();
  page.open_table({"direction", "tested", "significant", "share (%)",
                   "level of detection (mm): 5 %", "half", "95 %"});
  for (const Row& row : rows) {
    const Detection& found = row.found;
    html.open("tr");
    html.element("td", {}, row.name);
    page.number(grouped(found.tested));
    page.number(grouped(found.significant));
    page.number(found.tested == 0 ? "-"
                                  : text_of(100 * static_cast<double>(found.significant) /
                                                static_cast<double>(found.points),
                                            2));
    for (const double level_m : found.levels_m) page.number(told_mm(level_m));
    html.close();
  }
  page.close_table();
  page.note(
      "A distance beyond its level of detection is significant. The share is of all points; those "
      "whose place was seen through, or that have nothing near, need no level.");
}

std::vector<PictureMark> marks_of(const Comparison& forward, const Comparison* reverse,
                                  std::span<const ChangePlace> places) {
  std::vector<PictureMark> out;
  for (const ChangePlace& place : places)
    out.push_back({std::to_string(place.row + 1), place.points(forward, reverse)});
  return out;
}

void add_pictures(Page& page, const Comparison& forward, const Comparison* reverse,
                  std::span<const ChangePlace> places, const DeviationScale& scale, Task& task) {
  page.heading("Where");
  struct Picture {
    const char* title;
    const Comparison* of;
    bool only_significant;
  };
  std::vector<Picture> pictures{{"Compared with the reference", &forward, false}};
  if (reverse != nullptr) pictures.push_back({"Reference with the compared", reverse, false});
  if (forward.points.find("significant") != nullptr)
    pictures.push_back({"Compared with the reference: only what is significant", &forward, true});
  const std::vector<PictureMark> marks = marks_of(forward, reverse, places);
  std::vector<std::string> drawn(pictures.size());
  parallel_chunks(task, pictures.size(), [&](size_t k) {
    DeviationPictureSettings settings;
    settings.marks = marks;
    settings.title = pictures[k].title;
    settings.only_significant = pictures[k].only_significant;
    drawn[k] = deviation_svg(*pictures[k].of, scale, settings, task);
  });
  page.html().open("div", {{"style", kComparisonReportSideBySide}});
  for (const std::string& svg : drawn) page.html().raw(svg);
  page.html().close();
  page.note(
      std::string("Points of the first-named cloud, coloured by their distance from the other") +
      (reverse != nullptr ? "; both on one scale." : ".") +
      (marks.empty() ? ""
                     : " Outlines are of what changed in either epoch, numbered as "
                       "in the table."));
}

struct DrawnHistogram {
  std::string svg;
  bool has_law = false;
};

DrawnHistogram histogram_of(const Comparison& comparison, const DeviationScale& scale,
                            const ComparisonReportSettings& settings, Task& task) {
  const double threshold_m = settings.threshold_m;
  const Fitted fitted = fit(comparison, scale, settings, task);
  std::vector<ChartMark> marks;
  if (threshold_m > 0) marks.push_back({threshold_m, "threshold"});
  if (threshold_m > 0 && scale.is_signed) marks.push_back({-threshold_m, "threshold"});
  return {distance_chart(fitted.histogram, fitted.law ? &*fitted.law : nullptr, marks,
                         fitted.law_values),
          fitted.law.has_value()};
}

void add_histograms(Page& page, const Comparison& forward, const Comparison* reverse,
                    const DeviationScale& scale, const ComparisonReportSettings& settings,
                    Task& task) {
  page.heading("How far");
  page.html().open("div", {{"style", kComparisonReportSideBySide}});
  std::vector<const Comparison*> both{&forward};
  if (reverse != nullptr) both.push_back(reverse);
  std::vector<DrawnHistogram> drawn(both.size());
  parallel_chunks(task, both.size(),
                  [&](size_t k) { drawn[k] = histogram_of(*both[k], scale, settings, task); });
  bool has_law = false;
  for (const DrawnHistogram& one : drawn) {
    page.html().raw(one.svg);
    has_law = has_law || one.has_law;
  }
  page.html().close();
  if (!has_law) return;
  page.note(std::string("The curve is the noise law fitted to the distances ") +
            (settings.threshold_m > 0 ? "below the threshold" : "shown") +
            "; what rises above it " + (scale.is_signed ? "on either side" : "to the right") +
            " is more than noise.");
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
  const std::vector<ChangePlace> places =
      change_places(forward, reverse, changes, settings.threshold_m, kMostMarks, task);
  add_summary(page, forward, reverse, !scale.is_signed);
  add_landslide(page, forward);
  if (changes.size() > 0) add_change_table(page, changes);
  if (settings.picture) add_pictures(page, forward, reverse, places, scale, task);
  add_viewer(page, comparison_scene(forward, reverse, changes, scale), settings.viewer_points,
             task);
  add_histograms(page, forward, reverse, scale, settings, task);
  add_detection(page, forward, reverse, task);
  add_more(page, forward);
  if (!notes.input.empty()) {
    page.heading("Input");
    add_pairs(page, notes.input);
  }
  add_parameters(page, forward.parameters_json);
  add_times(page, notes);
  if (settings.picture) {
    const std::span<const ChangePlace> shown(places.data(), std::min(places.size(), kMostPages));
    add_change_pages(page, forward, reverse, changes, shown, scale, task);
    if (places.size() > kMostPages)
      page.note("Pages for the first " + std::to_string(kMostPages) + " of " +
                std::to_string(places.size()) + ".");
  }
  page.note("Written by Jalon.");
  return page.html().take();
}

std::string comparison_histogram(const Comparison& comparison,
                                 const ComparisonReportSettings& settings, Task& task) {
  const Comparison* one[] = {&comparison};
  return histogram_of(comparison, deviation_scale(one, settings.limit_m), settings, task).svg;
}

}  // namespace jalon
