// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/registration_report.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/setting_rows.h"
#include "base/text_number.h"
#include "cloud/operations.h"
#include "cloud/select.h"
#include "cloud/subsample_cells.h"
#include "compare/distance/distance.h"
#include "report/charts/convergence_chart.h"
#include "report/charts/distance_chart.h"
#include "report/pages/html_frame.h"
#include "report/pages/html_model.h"
#include "report/pages/registration_view.h"
#include "report/pages/registration_tables_html.h"
#include "report/sheet/ticks.h"
#include "report/viewer/view_page.h"

namespace jalon {

namespace {

constexpr auto kRegistrationReportRows = setting_rows(
    integer_row<&RegistrationReportSettings::bins>("bins", 5, 400, "1", "",
                                                   "Bins of the histograms"),
    integer_row<&RegistrationReportSettings::sample>(
        "sample", 1, 1e9, "points", "", "Most points of the moving cloud in the histograms"),
    integer_row<&RegistrationReportSettings::viewer_points>("viewer_points", 0, 1e9, "points", "",
                                                            kViewerPointsHelp));

constexpr const char* kRegistrationReportSideBySide =
    "display:grid;grid-template-columns:repeat(auto-fit,minmax(26rem,1fr));gap:1rem";

// Every nth point, so that at most this many are left.
Cloud sample_of(const Cloud& cloud, size_t most, Task& task) {
  std::vector<uint64_t> taken;
  const size_t stride = std::max<size_t>(1, (cloud.size() + most - 1) / most);
  for (size_t i = 0; i < cloud.size(); i += stride) taken.push_back(i);
  return select_kept(cloud, taken, task);
}

// As the registration used it: lines of a spinning scanner span no planes before they are thinned.
CloudPtr as_registered(const CloudPtr& reference, const Registration& r, Task& task) {
  const Column* cell = r.summary.find("thinning_cell");
  if (cell == nullptr || !(cell->number(0) > 0)) return reference;
  return std::make_shared<const Cloud>(
      one_per_voxel(*reference, cell->number(0), Keep::kCentroid, task));
}

struct Distances {
  std::vector<double> sorted;
  uint64_t modelled = 0;  ///< those from a plane
};

// Distances from local planes of the reference: the spacing of its points is no part of them. Where none
// reaches, the nearest of its points stands for it.
Distances distances(const CloudPtr& reference, Cloud cloud, Task& task) {
  DistanceSettings settings;
  settings.local_model = LocalModelKind::kPlane;
  const Comparison made =
      compare_distance(reference, std::make_shared<const Cloud>(std::move(cloud)), settings, task);
  Distances out;
  for (const double d : made.points.require("distance").values<double>())
    if (std::isfinite(d)) out.sorted.push_back(std::abs(d));
  std::sort(out.sorted.begin(), out.sorted.end());
  out.modelled = made.summary.require("modelled").values<uint64_t>()[0];
  return out;
}

double share_below(const std::vector<double>& sorted, double share) {
  return sorted[std::min(sorted.size() - 1,
                         static_cast<size_t>(share * static_cast<double>(sorted.size())))];
}

void add_histogram(Page& page, const char* title, const Distances& found, int64_t bins) {
  const std::vector<double>& sorted = found.sorted;
  page.html().open("div").element("h3", {}, title);
  if (sorted.empty()) {
    page.note("No point of the moving cloud has a distance.");
  } else {
    constexpr double kShown =
        0.98;  // of the points; the far ones would press the others into one bin
    const HistogramSettings bounds{
        .bins = static_cast<uint64_t>(bins),
        .maximum = round_up_125(std::max(share_below(sorted, kShown), 1e-6))};
    page.html().raw(distance_chart(field_counts(sorted, bounds), nullptr, {}));
    double squares = 0;
    for (const double d : sorted) squares += d * d;
    page.note("median " + text_of(1000 * share_below(sorted, 0.5), 2) + " mm, 95 % below " +
              text_of(1000 * share_below(sorted, 0.95), 2) + " mm, rms " +
              text_of(1000 * std::sqrt(squares / static_cast<double>(sorted.size())), 2) + " mm");
    if (const uint64_t bare = sorted.size() - found.modelled; bare > 0)
      page.note("The figures have " + std::to_string(bare) +
                (bare == 1 ? " distance" : " distances") +
                " from the nearest point of the reference, where no plane of it is nearer.");
  }
  page.html().close();
}

void add_before_after(Page& page, const Registration& r, const CloudPtr& reference,
                      const CloudPtr& moving, const RegistrationReportSettings& settings,
                      Task& task) {
  page.heading("Distances before and after");
  const Cloud sample = sample_of(*moving, static_cast<size_t>(settings.sample), task);
  const Cloud moved = transformed(sample, r.pose, task);
  const CloudPtr surface = as_registered(reference, r, task);
  page.html().open("div", {{"style", kRegistrationReportSideBySide}});
  add_histogram(page, "Before", distances(surface, sample, task), settings.bins);
  add_histogram(page, "After", distances(surface, moved, task), settings.bins);
  page.html().close();
  page.note(
      "Distances of " + std::to_string(sample.size()) +
      " evenly taken points of the moving cloud from local "
      "planes of the reference; points that the reference does not have are in them. Axes differ.");
}

}  // namespace

std::span<const ParamRow> registration_report_rows() { return kRegistrationReportRows; }

std::string registration_html(const Registration& r, const CloudPtr& reference,
                              const CloudPtr& moving, std::string_view notes_json,
                              const RegistrationReportSettings& settings, Task& task) {
  const ProgressSpan span(task, 0, 1, "writing the report");
  const Notes notes = read_notes(notes_json);
  Page page;
  open_page(page, notes.title);
  page.html().open("h1").element("bdi", {}, notes.title).close();
  page.html().element("p", {{"class", "lead"}}, outcome_text(r));
  add_pose(page, r);
  add_search(page, r);
  add_directions(page, r);
  add_pairs_table(page, r);
  if (reference != nullptr && moving != nullptr && reference->size() > 0 && moving->size() > 0) {
    add_viewer(page, registration_scene(r, reference, moving), settings.viewer_points, task);
    add_before_after(page, r, reference, moving, settings, task);
  }
  if (const std::string chart = convergence_chart(r.iteration_log); !chart.empty()) {
    page.heading("Convergence");
    page.html().raw(chart);
  }
  if (!notes.input.empty()) {
    page.heading("Input");
    add_pairs(page, notes.input);
  }
  add_parameters(page, r.parameters_json);
  add_times(page, notes);
  page.note("Written by Jalon.");
  return page.html().take();
}

}  // namespace jalon
