// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/adjustment_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/setting_rows.h"
#include "base/table_columns.h"
#include "base/text_number.h"
#include "fieldtools/field_normality.h"
#include "report/charts/convergence_chart.h"
#include "report/charts/drive_chart.h"
#include "report/charts/residual_chart.h"
#include "report/pages/adjustment_view.h"
#include "report/pages/html_frame.h"
#include "report/pages/html_model.h"
#include "report/pictures/drive_plan.h"
#include "report/pictures/facade_section.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"
#include "report/viewer/view_page.h"

namespace jalon {

namespace {

constexpr auto kAdjustmentReportRows = setting_rows(
    integer_row<&AdjustmentReportSettings::bins>("bins", 5, 400, "1", "", "Bins of the histogram"),
    integer_row<&AdjustmentReportSettings::strips>(
        "strips", 0, 1000, "1", "", "Most strips in the table of those that moved most"),
    integer_row<&AdjustmentReportSettings::viewer_points>("viewer_points", 0, 1e9, "points", "",
                                                          kViewerPointsHelp));

constexpr double kRareChance =
    0.001;  // of chi-square: below it the sigmas or the matches are wrong
constexpr const char *kEast = "#b3472f", *kNorth = "#1f6f8b", *kEastTrue = "#e0a08f",
                     *kNorthTrue = "#8fc1d4";

std::string length_mm(double metres, int decimals = 1) {
  return std::isfinite(metres) ? text_of(1000 * metres, decimals) : "-";
}

uint64_t accepted(const JointAdjustment& a) {
  return static_cast<uint64_t>(
      std::ranges::count(a.matches, MatchState::kMatched, &PointMatch::state));
}

std::string adjustment_outcome(const JointAdjustment& a) {
  return std::string(a.converged ? "Converged" : "Not converged") + " after " +
         grouped(a.passes.size()) + (a.passes.size() == 1 ? " pass: " : " passes: ") +
         grouped(accepted(a)) + " of " + grouped(a.points.size()) + " points lie on " +
         grouped(a.strips) + " strips.";
}

// ---- what came out -----------------------------------------------------------------------------------------------

struct SigmaMeans {
  double before = 0, after = 0, greatest_m = 0;
};

SigmaMeans sigma_means(const JointAdjustment& a) {
  SigmaMeans out;
  const double n = 2 * static_cast<double>(a.trajectory_sigmas.size());
  for (size_t c = 0; c < a.trajectory_sigmas.size(); ++c) {
    out.before += (a.trajectory_priors[c].u + a.trajectory_priors[c].v) / n;
    out.after += (a.trajectory_sigmas[c].u + a.trajectory_sigmas[c].v) / n;
    out.greatest_m = std::max(out.greatest_m, norm(a.trajectory.by_m[c]));
  }
  return out;
}

// Each with its standard deviation.
std::string angles_mdeg(const JointAdjustment& a) {
  constexpr double kMdeg = 180e3 / std::numbers::pi;
  std::string out;
  for (int k = 0; k < 3; ++k)
    out += text_of(kMdeg * a.attitude_bias_rad[k], 1) + " +- " +
           text_of(kMdeg * a.attitude_bias_sigmas_rad[k], 1) + (k < 2 ? ", " : " mdeg");
  return out;
}

std::string heights_told(const JointAdjustment& a) {
  double greatest = 0, before = 0, after = 0;
  const auto n = static_cast<double>(a.heights_m.size());
  for (size_t c = 0; c < a.heights_m.size(); ++c) {
    greatest = std::max(greatest, std::fabs(a.heights_m[c]));
    before += a.height_priors_m[c] / n, after += a.height_sigmas_m[c] / n;
  }
  return "corrected by up to " + length_mm(greatest) + " mm in " + grouped(a.ground.size()) +
         " intervals, standard deviation " + length_mm(before) + " mm before, " + length_mm(after) +
         " mm after";
}

void add_outcome(Page& page, const JointAdjustment& a) {
  const SigmaMeans sigmas = sigma_means(a);
  std::vector<std::pair<std::string, std::string>> rows{
      {"greatest correction of the drive", length_mm(sigmas.greatest_m) + " mm"},
      {"mean standard deviation of the drive",
       length_mm(sigmas.before) + " mm before, " + length_mm(sigmas.after) + " mm after"},
      {"points off their strips, rms",
       length_mm(a.passes.empty() ? kNaN : a.passes.back().rms_m) + " mm"},
      {"chi-square of all corrections", text_of(a.chi_square, 1) + " on " + grouped(a.strips) +
                                            " degrees of freedom, p " + text_of(a.p_value, 4)}};
  if (!(a.attitude_bias_sigmas_rad == Vec3{}))
    rows.push_back({"roll, pitch, heading off by a constant", angles_mdeg(a)});
  if (!a.ground.empty()) rows.push_back({"heights by the ground", heights_told(a)});
  if (std::isfinite(a.wrong_share))
    rows.push_back({"matches to another strip than the cloud says",
                    text_of(100 * a.wrong_share, 2) + " %, to another facade " +
                        text_of(100 * a.wrong_facade_share, 2) + " %"});
  page.heading("What came out");
  add_pairs(page, rows);
  if (a.p_value < kRareChance)
    page.note(
        "So large a chi-square has a chance below one in a thousand: the standard deviations given "
        "are too small, "
        "or matches are wrong.");
  if (a.weak_share < kHeldShare)
    page.note("Nothing is known along the direction (" + text_of(a.weak_direction.u, 3) + ", " +
              text_of(a.weak_direction.v, 3) + "): no wall seen stands across it.");
  if (const auto doubtful = std::ranges::count(a.strip_is_doubtful, true); doubtful > 0)
    page.note(grouped(static_cast<uint64_t>(doubtful)) +
              (doubtful == 1 ? " strip was" : " strips were") +
              " not adjusted: what is seen may be the wall of another, and nothing "
              "tells which.");
  if (a.points.outside > 0)
    page.note(grouped(a.points.outside) +
              " points are outside of the trajectory's time and moved as its ends do.");
}

// ---- along the drive ---------------------------------------------------------------------------------------------

std::vector<double> component(const std::vector<Vec2>& list, double Vec2::*which) {
  std::vector<double> out;
  for (const Vec2& v : list) out.push_back(v.*which);
  return out;
}

// What the correction of each control time should have been; NaN where the truth does not reach.
std::vector<Vec2> true_corrections(const JointAdjustment& a, const AdjustedInputs& inputs) {
  const Trajectory &given = inputs.trajectory, &truth = *inputs.truth;
  std::vector<Vec2> out(a.trajectory.times_s.size(), Vec2{kNaN, kNaN});
  TimePlace here, there;
  for (size_t c = 0; c < out.size(); ++c) {
    const double t = a.trajectory.times_s[c];
    if (t < truth.times_s.front() || t > truth.times_s.back()) continue;
    here = time_place(given.times_s, t, c, here.epoch);
    there = time_place(truth.times_s, t, c, there.epoch);
    const Vec3 by = between(truth.positions, there) - between(given.positions, here);
    out[c] = {by.x, by.y};
  }
  return out;
}

void add_drive(Page& page, const JointAdjustment& a, const AdjustedInputs& inputs) {
  const std::vector<double>& times = a.trajectory.times_s;
  page.heading("Along the drive");
  page.html().element("h3", {}, "Standard deviations of the position");
  const DriveCurve sigmas[] = {
      {"east, after", kEast, false, component(a.trajectory_sigmas, &Vec2::u)},
      {"north, after", kNorth, false, component(a.trajectory_sigmas, &Vec2::v)},
      {"east, before", kEast, true, component(a.trajectory_priors, &Vec2::u)},
      {"north, before", kNorth, true, component(a.trajectory_priors, &Vec2::v)}};
  page.html().raw(
      drive_chart("Standard deviations along the drive", times, sigmas, DriveAxis::kLogarithmic));
  page.html().element("h3", {}, "Corrections");
  std::vector<DriveCurve> curves{{"east", kEast, false, component(a.trajectory.by_m, &Vec2::u)},
                                 {"north", kNorth, false, component(a.trajectory.by_m, &Vec2::v)}};
  if (inputs.truth != nullptr) {
    const std::vector<Vec2> truth = true_corrections(a, inputs);
    curves.push_back({"east, true", kEastTrue, true, component(truth, &Vec2::u)});
    curves.push_back({"north, true", kNorthTrue, true, component(truth, &Vec2::v)});
  }
  page.html().raw(drive_chart("Corrections along the drive", times, curves, DriveAxis::kFromZero));
}

// ---- distances ---------------------------------------------------------------------------------------------------

Residuals binned(const std::vector<double>& values, const SampleStatistics& statistics,
                 size_t bins) {
  constexpr double kShown = 4;  // standard deviations to either side
  Residuals out;
  out.count = values.size();
  out.mean_m = statistics.mean, out.sigma_m = statistics.deviation;
  out.half_range_m = round_up_125(std::max(kShown * statistics.deviation, 1e-4));
  out.bins.assign(bins, 0);
  for (const double v : values) {
    const double at = (v + out.half_range_m) / out.bin_width_m();
    if (at < 0) ++out.below;
    else if (at >= static_cast<double>(bins)) ++out.above;
    else ++out.bins[static_cast<size_t>(at)];
  }
  return out;
}

void add_distances(Page& page, const JointAdjustment& a, size_t bins) {
  std::vector<double> values;
  for (size_t i = 0; i < a.matches.size(); ++i)
    if (a.matches[i].state == MatchState::kMatched && a.weights[i] > 0)
      values.push_back(a.matches[i].distance_m);
  page.heading("Distances of the matched points from their strips");
  if (values.size() < kLeastShapiroWilk) {
    page.note("Fewer than three points count.");
    return;
  }
  const SampleStatistics s = sample_statistics(values);
  const Residuals residuals = binned(values, s, bins);
  page.html().raw(residual_chart(residuals));
  std::string said = "mean " + length_mm(s.mean, 2) + " mm, median " + length_mm(s.median, 2) +
                     " mm, standard deviation " + length_mm(s.deviation, 2) + " mm";
  if (s.deviation > 0) {
    const NormalityReport test = test_normality(values, {});
    said += ", skewness " + text_of(s.skewness, 2) + ", excess kurtosis " + text_of(s.kurtosis, 2) +
            "; Shapiro-Wilk on " + grouped(test.tested) + " of them: W " + text_of(test.test.W, 4) +
            ", p " + text_of(test.test.p, 4);
  }
  page.note(said + ".");
  if (const uint64_t others = accepted(a) - values.size(); others > 0)
    page.note(grouped(others) +
              " accepted points off the middle of their strip do not count and are not in it.");
  if (const uint64_t off = residuals.below + residuals.above; off > 0)
    page.note(grouped(off) + (off == 1 ? " point lies" : " points lie") + " beyond the axis.");
}

void add_section(Page& page, const StripScene& scene, const JointAdjustment& a) {
  const auto facade = farthest_facade(scene, a);
  if (!facade) return;
  page.heading("A facade before and after");
  page.note("Facade " + std::to_string(*facade) +
            ", the farthest from its points as given, seen from above: its strips and its points.");
  page.html().raw(facade_section(scene, a, *facade));
}

// ---- matches and strips ------------------------------------------------------------------------------------------

void add_matches(Page& page, const JointAdjustment& a) {
  constexpr std::array<const char*, 6> kWords = {
      "accepted",
      "no strip on the ray, or a roof or the ground before it",
      "the ray meets the strip from inside the building",
      "farther from the strip than the sigmas allow",
      "of a wall that stands otherwise than the strip",
      "its match still changed late, and was left out"};
  std::array<uint64_t, kWords.size()> counts{};
  for (const PointMatch& m : a.matches) ++counts[static_cast<size_t>(m.state) - 1];
  page.heading("What became of the points");
  page.open_table({"", "points", "share (%)"});
  for (size_t i = 0; i < kWords.size(); ++i) {
    page.html().open("tr").element("td", {}, kWords[i]);
    page.number(grouped(counts[i]));
    page.number(a.matches.empty() ? "-"
                                  : text_of(100 * static_cast<double>(counts[i]) /
                                                static_cast<double>(a.matches.size()),
                                            1));
    page.html().close();
  }
  page.close_table();
}

// How far a strip moved in all: of its own, with its facade, and with its block along the normal.
std::vector<double> whole_shifts(const StripScene& scene, const JointAdjustment& a) {
  std::vector<double> out;
  for (uint32_t s = 0; s < scene.strips.size(); ++s)
    out.push_back(shift_of(scene.strips[s], s, a.model));
  return out;
}

void add_strips(Page& page, const StripScene& scene, const JointAdjustment& a, size_t most) {
  const std::vector<double> shifts = whole_shifts(scene, a);
  std::vector<uint32_t> order;
  for (uint32_t s = 0; s < shifts.size(); ++s)
    if (a.strip_points[s] > 0) order.push_back(s);
  std::ranges::stable_sort(order, std::greater{}, [&](uint32_t s) { return std::abs(shifts[s]); });
  order.resize(std::min(order.size(), most));
  if (order.empty()) return;
  page.heading("The strips that moved most");
  page.open_table({"strip", "facade", "block", "points", "moved along the normal (mm)",
                   "of its own (mm)", "sigma (mm)", "before its points (mm)"});
  for (const uint32_t s : order) {
    page.html().open("tr");
    for (const uint32_t n : {s, scene.strips[s].facade, scene.strips[s].block})
      page.number(std::to_string(n));
    page.number(grouped(a.strip_points[s]));
    page.number(length_mm(shifts[s]));
    page.number(length_mm(a.model.strips[s]));
    page.number(length_mm(a.strip_sigmas[s]));
    page.number(length_mm(a.strip_distances_m[s]));
    page.html().close();
  }
  page.close_table();
  page.note(
      "Numbers count from 0, as in the tables. Before its points: the strip as given, the points "
      "as given.");
}

void add_convergence(Page& page, const JointAdjustment& a) {
  FieldTable log;
  add_column<double>(log, a.passes, "rms", "m", "", [](const JointPass& p) { return p.rms_m; });
  add_column<double>(log, a.passes, "shift", "m", "", [](const JointPass& p) { return p.step_m; });
  if (const std::string chart = convergence_chart(log); !chart.empty()) {
    page.heading("Convergence");
    page.html().raw(chart);
  }
}

}  // namespace

std::span<const ParamRow> adjustment_report_rows() { return kAdjustmentReportRows; }

std::string adjustment_html(const JointAdjustment& adjustment, const AdjustedInputs& inputs,
                            std::string_view notes_json, const AdjustmentReportSettings& settings,
                            Task& task) {
  const ProgressSpan span(task, 0, 1, "writing the report");
  const Notes notes = read_notes(notes_json);
  const StripScene scene = strip_scene(inputs.model, false);
  Page page;
  open_page(page, notes.title);
  page.html().open("h1").element("bdi", {}, notes.title).close();
  page.html().element("p", {{"class", "lead"}}, adjustment_outcome(adjustment));
  add_outcome(page, adjustment);
  page.heading("Plan");
  page.html().raw(drive_plan(scene, adjustment, inputs.trajectory, inputs.truth));
  if (settings.viewer_points > 0)
    add_viewer(page, adjustment_scene(adjustment, inputs), settings.viewer_points, task);
  add_drive(page, adjustment, inputs);
  add_distances(page, adjustment, static_cast<size_t>(settings.bins));
  add_section(page, scene, adjustment);
  add_matches(page, adjustment);
  add_strips(page, scene, adjustment, static_cast<size_t>(settings.strips));
  add_convergence(page, adjustment);
  if (!notes.input.empty()) {
    page.heading("Input");
    add_pairs(page, notes.input);
  }
  add_parameters(page, adjustment.parameters_json);
  add_times(page, notes);
  page.note("Written by Jalon.");
  return page.html().take();
}

}  // namespace jalon
