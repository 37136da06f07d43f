// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/clearance_chart.h"

#include <algorithm>
#include <cmath>

#include "formats/drawings/svg_writer.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

// Of the chart, in millimetres.
constexpr double kWayWidth = 180, kWayHeight = 74, kWayLeft = 16, kWayRight = 176, kWayTop = 12,
                 kWayBottom = 58;
constexpr double kWayText = 2.6;
constexpr size_t kWayBars =
    1600;  ///< ten a millimetre: more intervals share one, and the least of them is drawn

struct WayPlot {
  double length_m, low_m, high_m;
  double x(double chainage_m) const {
    return kWayLeft + chainage_m / length_m * (kWayRight - kWayLeft);
  }
  double y(double clearance_m) const {
    return kWayBottom - (std::clamp(clearance_m, low_m, high_m) - low_m) / (high_m - low_m) *
                            (kWayBottom - kWayTop);
  }
};

WayPlot way_plot_of(const Column& clearance, double length_m, double margin_m) {
  WayPlot plot{length_m, 0, margin_m};
  for (size_t i = 0; i < clearance.count(); ++i) {
    const double value = clearance.number(i);
    if (!std::isfinite(value)) continue;
    plot.low_m = std::min(plot.low_m, value), plot.high_m = std::max(plot.high_m, value);
  }
  constexpr double kAir = 0.05;  // above and below the bars
  const double range = std::max(plot.high_m - plot.low_m, 1e-3);
  plot.high_m += kAir * range;
  if (plot.low_m < 0) plot.low_m -= kAir * range;
  return plot;
}

void draw_way_axes(SvgWriter& svg, const WayPlot& plot) {
  constexpr double kLevels = 7, kMarks = 12;  // at most so many
  const Ticks levels = make_ticks(plot.low_m, plot.high_m, (plot.high_m - plot.low_m) / kLevels);
  for (const double m : levels.values) {
    svg_line(svg, {kWayLeft, plot.y(m)}, {kWayRight, plot.y(m)}, kFaint, 0.15);
    svg_text(svg, {kWayLeft - 1.5, plot.y(m) + 0.9}, kWayText, Anchor::kEnd, levels.label(m));
  }
  const Ticks marks = make_ticks(0, plot.length_m, plot.length_m / kMarks);
  for (const double m : marks.values) {
    svg_line(svg, {plot.x(m), kWayBottom}, {plot.x(m), kWayBottom + 1.5}, kInk, 0.2);
    svg_text(svg, {plot.x(m), kWayBottom + 4.8}, kWayText, Anchor::kMiddle, marks.label(m));
  }
  svg_line(svg, {kWayLeft, kWayTop}, {kWayLeft, kWayBottom}, kInk, 0.25);
  svg_line(svg, {kWayLeft, kWayBottom}, {kWayRight, kWayBottom}, kInk, 0.25);
  svg_text(svg, {(kWayLeft + kWayRight) / 2, kWayBottom + 10.5}, 3, Anchor::kMiddle,
           "Way of the gauge (m)");
  svg_text(svg, {4, (kWayTop + kWayBottom) / 2}, 3, Anchor::kMiddle, "Clearance (m)", false, true);
}

void draw_way_bars(SvgWriter& svg, const WayPlot& plot, const Column& clearance,
                   const GaugePath& path, double margin_m) {
  const size_t n = clearance.count(), count = std::min(n, kWayBars);
  for (size_t b = 0; b < count; ++b) {
    const size_t from = b * n / count, to = (b + 1) * n / count;
    double least = INFINITY;
    for (size_t i = from; i < to; ++i)
      if (std::isfinite(clearance.number(i))) least = std::min(least, clearance.number(i));
    if (!std::isfinite(least)) continue;
    constexpr double kThinnest = 0.15;  // mm: a bar at 0 is seen as well
    const double left = plot.x(path.chainage_m(static_cast<double>(from))),
                 right = plot.x(path.chainage_m(static_cast<double>(to))),
                 top = plot.y(std::max(least, 0.0)), bottom = plot.y(std::min(least, 0.0));
    svg.leaf("rect", {{"x", left},
                      {"y", std::min(top, bottom - kThinnest)},
                      {"width", std::max(right - left, kThinnest)},
                      {"height", std::max(bottom - top, kThinnest)},
                      {"fill", clearance_colour(least, margin_m)}});
  }
}

// Numbers stand above the chart, those that would cover a tighter one are left out.
void draw_way_numbers(SvgWriter& svg, const WayPlot& plot, std::span<const TightPlace> tight) {
  std::vector<double> taken;
  for (size_t i = 0; i < tight.size(); ++i) {
    constexpr double kRoom = 5;  // mm a number
    const double x = plot.x(tight[i].chainage_m);
    const auto covers = [&](double other) { return std::abs(other - x) < kRoom; };
    if (std::any_of(taken.begin(), taken.end(), covers)) continue;
    taken.push_back(x);
    svg_line(svg, {x, kWayTop - 1}, {x, plot.y(tight[i].clearance_m)}, kGrey, 0.15);
    svg_text(svg, {x, kWayTop - 2}, 3, Anchor::kMiddle, std::to_string(i + 1), true);
  }
}

}  // namespace

const char* clearance_colour(double clearance_m, double margin_m) {
  return clearance_m <= 0 ? "#c0392b" : clearance_m <= margin_m ? "#e08e0b" : "#2e7d52";
}

std::string clearance_chart(const FieldTable& intervals, const GaugePath& path,
                            std::span<const TightPlace> tight, double margin_m) {
  const Column& clearance = intervals.require("clearance");
  if (!(path.length_m() > 0) || clearance.count() == 0) return {};
  const WayPlot plot = way_plot_of(clearance, path.length_m(), margin_m);
  SvgWriter svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox", "0 0 " + svg_number(kWayWidth) + " " + svg_number(kWayHeight)},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, "Least clearance along the way of the gauge");
  draw_way_axes(svg, plot);
  draw_way_bars(svg, plot, clearance, path, margin_m);
  svg_line(svg, {kWayLeft, plot.y(0)}, {kWayRight, plot.y(0)}, kInk, 0.25);
  svg.leaf("path", {{"d", svg_polyline(std::vector<Vec2>{{kWayLeft, plot.y(margin_m)},
                                                         {kWayRight, plot.y(margin_m)}})},
                    {"fill", "none"},
                    {"stroke", "#c0392b"},
                    {"stroke-width", 0.25},
                    {"stroke-dasharray", "1.5 1"}});
  draw_way_numbers(svg, plot, tight);
  return svg.take();
}

}  // namespace jalon
