// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/network_report.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/text_number.h"
#include "registration/network/network_tables.h"
#include "report/pages/html_frame.h"
#include "report/pages/html_model.h"
#include "report/pictures/network_plan.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

namespace {

constexpr double kMm_per_m = 1e3, kGon_per_rad = 200 / std::numbers::pi,
                 kMgon_per_rad = 1e3 * kGon_per_rad;
constexpr size_t kMostNetworkRows = 2000;  // of a table; all are in the tables of the network

std::string fixed(double value, int decimals) {
  return std::isfinite(value) ? text_of(value, decimals) : "-";
}

// An axis points both ways: 0 to 200.
double half_circle_gon(double azimuth_rad) {
  const double gon = std::fmod(azimuth_rad * kGon_per_rad, 200);
  return gon < 0 ? gon + 200 : gon;
}

// Pieces of what the table of observations says, in the order of ObservationKind.
struct KindText {
  const char* name;
  bool is_angle;
};
constexpr KindText kKinds[] = {
    {"direction", true}, {"zenith angle", true}, {"distance", false}, {"x", false},
    {"y", false},        {"z", false},           {"centring", false}, {"instrument height", false}};

void add_network_lead(Page& page, const NetworkAdjustment& n, const std::string& title) {
  page.html().open("h1").element("bdi", {}, title).close();
  const auto outliers = std::count_if(n.observations.begin(), n.observations.end(),
                                      [](const AdjustedObservation& o) { return o.is_outlier; });
  page.html().element("p", {{"class", "lead"}},
                      grouped(n.points.size()) + " points, " + grouped(n.survey.setups.size()) +
                          " setups, " + grouped(n.observations.size()) + " observations, " +
                          std::to_string(n.redundancy) + " to spare. " +
                          (n.is_converged ? "" : "The adjustment has not converged. ") +
                          (outliers == 0 ? "No outliers."
                                         : grouped(static_cast<uint64_t>(outliers)) +
                                               (outliers == 1 ? " outlier, " : " outliers, ") +
                                               grouped(n.rejected) + " of them left out."));
  std::vector<std::pair<std::string, std::string>> pairs{
      {"global test", "p = " + fixed(n.p_value, 4)},
      {"sigma0", fixed(n.sigma0, 3)},
      {"weighted squares", fixed(n.weighted_squares, 2)},
      {"unknowns", std::to_string(n.unknowns)}};
  if (n.defect > 0) pairs.emplace_back("inner constraints", std::to_string(n.defect));
  add_pairs(page, pairs);
}

void add_points(Page& page, const NetworkAdjustment& n) {
  const FieldTable table = network_points(n);
  const auto sigma = table.require("sigma").values<double>(),
             major = table.require("ellipse_major").values<double>(),
             minor = table.require("ellipse_minor").values<double>(),
             azimuth = table.require("ellipse_azimuth").values<double>();
  page.heading("Points");
  page.open_table({"point", "code", "East m", "North m", "height m", "s East mm", "s North mm",
                   "s height mm", "95 % ellipse mm", "azimuth gon"});
  for (size_t i = 0; i < std::min(n.points.size(), kMostNetworkRows); ++i) {
    const Vec3& p = n.points[i].position;
    page.html().open("tr");
    page.foreign("td", n.survey.points[i].id);
    page.foreign("td", n.survey.points[i].code);
    for (int axis = 0; axis < 3; ++axis) page.number(fixed(p[axis], 4));
    for (size_t axis = 0; axis < 3; ++axis) {
      const double s = sigma[3 * i + axis];
      page.number(s == 0 ? "fixed" : fixed(s * kMm_per_m, 2));
    }
    const bool has_ellipse = major[i] > 0;
    page.number(has_ellipse ? fixed(kEllipse95 * major[i] * kMm_per_m, 2) + " x " +
                                  fixed(kEllipse95 * minor[i] * kMm_per_m, 2)
                            : "");
    page.number(has_ellipse ? fixed(half_circle_gon(azimuth[i]), 1) : "");
    page.html().close();
  }
  page.close_table();
  page.note("s: standard deviations. Semi-axes of the ellipse that holds the point with 95 %.");
}

void add_reliability(Page& page, const NetworkAdjustment& n) {
  constexpr double kWellControlled = 0.3;  // Foerstner 1979: a share above is good
  constexpr double kBarely = 0.1, kNone = 1e-6;
  size_t good = 0, fair = 0, poor = 0, none = 0;
  for (const AdjustedObservation& o : n.observations) {
    const double r = o.redundancy;
    ++(r > kWellControlled ? good : r > kBarely ? fair : r > kNone ? poor : none);
  }
  page.heading("Reliability (Baarda)");
  page.open_table({"share r of an error that shows", "observations"});
  const std::pair<const char*, size_t> rows[] = {{"above 0.3: well controlled", good},
                                                 {"0.1 to 0.3", fair},
                                                 {"below 0.1: barely controlled", poor},
                                                 {"0: nothing controls them", none}};
  for (const auto& [name, count] : rows) {
    page.html().open("tr").element("td", {}, name);
    page.number(grouped(count));
    page.html().close();
  }
  page.close_table();
}

void add_observation(Page& page, const NetworkAdjustment& n, const FieldTable& table, size_t i) {
  const AdjustedObservation& o = n.observations[i];
  const KindText& kind = kKinds[static_cast<size_t>(n.kinds[i].kind) - 1];
  const double unit = kind.is_angle ? kMgon_per_rad : kMm_per_m;
  const uint64_t from = table.require("from").values<uint64_t>()[i],
                 to = table.require("to").values<uint64_t>()[i],
                 line = table.require("line").values<uint64_t>()[i];
  page.html().open("tr");
  page.html().element("td", {}, kind.name);
  page.foreign("td", n.survey.points[from].id);
  page.foreign("td", from == to ? "" : n.survey.points[to].id);
  page.number(line == 0 ? "" : std::to_string(line));
  page.number(kind.is_angle ? fixed(o.measured * kGon_per_rad, 5) + " gon"
                            : fixed(o.measured, 4) + " m");
  page.number(fixed(o.residual * unit, 2) + (kind.is_angle ? " mgon" : " mm"));
  page.number(fixed(o.sigma * unit, 2));
  page.number(fixed(o.redundancy, 2));
  page.number(fixed(o.normalised, 2));
  page.number(fixed(o.p_value, 4));
  page.number(fixed(o.detectable * unit, 2));
  page.html().element("td", {}, !n.kinds[i].is_used ? "left out" : o.is_outlier ? "outlier" : "");
  page.html().close();
}

void add_observations(Page& page, const NetworkAdjustment& n, Task& task) {
  const FieldTable table = network_observations(n);
  std::vector<size_t> order(n.observations.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return std::fabs(n.observations[a].normalised) > std::fabs(n.observations[b].normalised);
  });
  page.heading("Observations, the largest normalised residual first");
  page.open_table({"kind", "from", "to", "line", "measured", "residual", "s", "r", "w", "p",
                   "detectable", "test"});
  for (size_t k = 0; k < std::min(order.size(), kMostNetworkRows); ++k) {
    if (k % 256 == 0) task.checkpoint(0.5);
    add_observation(page, n, table, order[k]);
  }
  page.close_table();
  page.note(
      "s: standard deviation of what was measured; r: redundancy, the share of an error that shows "
      "in the residual; w: residual over its standard deviation (Baarda); p: chance of as much by "
      "noise alone; detectable: the least error that the test finds. s and detectable in the unit "
      "of the residual.");
  if (order.size() > kMostNetworkRows)
    page.note(grouped(order.size() - kMostNetworkRows) + " more observations have smaller ones.");
}

}  // namespace

std::string network_html(const NetworkAdjustment& network, std::string_view parameters_json,
                         std::string_view notes_json, Task& task) {
  const ProgressSpan span(task, 0, 1, "writing the report");
  Notes told = read_notes(notes_json);
  if (notes_json.empty()) told.title = "Network report";
  Page page;
  open_page(page, told.title);
  add_network_lead(page, network, told.title);
  page.heading("Plan");
  page.html().raw(network_plan_svg(network, told.title, task));
  add_reliability(page, network);
  add_points(page, network);
  add_observations(page, network, task);
  page.heading("Input");
  add_pairs(page, told.input);
  add_parameters(page, parameters_json);
  add_times(page, told);
  page.note("Written by Jalon.");
  return page.html().take();
}

}  // namespace jalon
