// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/convergence_chart.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text_number.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

// The plot's window in the chart's millimetres.
constexpr double kWidth = 180, kHeight = 84, kConvergenceChartLeft = 20,
                 kConvergenceChartRight = 176, kConvergenceChartTop = 12,
                 kConvergenceChartBottom = 70;
constexpr double kConvergenceChartText = 2.8;

struct Curve {
  const char* column;
  const char* name;
  const char* colour;
  const char* dash;
};
constexpr Curve kCurves[] = {{"rms", "rms residual", "#1f6f8b", ""},
                             {"distance", "limit of residuals", "#777777", "1.5 1"},
                             {"shift", "shift of the step", "#b3472f", ""}};

struct Plot {
  double rows, low, high;  // decades: log10 of millimetres
  double x(double row) const {
    return kConvergenceChartLeft + (rows > 1 ? (row - 1) / (rows - 1) : 0.5) *
                                       (kConvergenceChartRight - kConvergenceChartLeft);
  }
  double y(double decade) const {
    return kConvergenceChartBottom -
           (decade - low) / (high - low) * (kConvergenceChartBottom - kConvergenceChartTop);
  }
};

double decade_of(double metres) { return std::log10(1000 * metres); }

Plot plot_of(const FieldTable& log) {
  Plot plot{0, INFINITY, -INFINITY};
  for (const Curve& curve : kCurves) {
    const Column* column = log.find(curve.column);
    if (column == nullptr) continue;
    plot.rows = static_cast<double>(column->count());
    for (size_t i = 0; i < column->count(); ++i)
      if (const double value = decade_of(column->number(i)); std::isfinite(value)) {
        plot.low = std::min(plot.low, value);
        plot.high = std::max(plot.high, value);
      }
  }
  plot.low = std::isfinite(plot.low) ? std::floor(plot.low) : 0;
  plot.high = std::isfinite(plot.high) ? std::max(std::ceil(plot.high), plot.low + 1) : 1;
  return plot;
}

void draw_level(SvgWriter& svg, const Plot& plot, double mm) {
  const double decade = std::log10(mm);
  svg_line(svg, {kConvergenceChartLeft, plot.y(decade)}, {kConvergenceChartRight, plot.y(decade)},
           kFaint, 0.15);
  svg_text(svg, {kConvergenceChartLeft - 1.5, plot.y(decade) + 1}, kConvergenceChartText,
           Anchor::kEnd, text_of(mm, static_cast<int>(std::max(0.0, -std::floor(decade + 1e-9)))));
}

void draw_axes(SvgWriter& svg, const Plot& plot) {
  const double decades = plot.high - plot.low, step = std::max(1.0, std::ceil(decades / 8));
  for (double decade = plot.low; decade <= plot.high; decade += step) {
    draw_level(svg, plot, std::pow(10, decade));
    if (decades > 2 || decade == plot.high) continue;
    for (const double between : {2, 5}) draw_level(svg, plot, between * std::pow(10, decade));
  }
  for (const double row :
       make_ticks(1, std::max(plot.rows, 2.0), std::max(1.0, plot.rows / 12)).values) {
    if (row != std::floor(row) || row > plot.rows) continue;
    svg_line(svg, {plot.x(row), kConvergenceChartBottom},
             {plot.x(row), kConvergenceChartBottom + 1.5}, kInk, 0.2);
    svg_text(svg, {plot.x(row), kConvergenceChartBottom + 5}, kConvergenceChartText,
             Anchor::kMiddle, text_of(row, 0));
  }
  svg_line(svg, {kConvergenceChartLeft, kConvergenceChartBottom},
           {kConvergenceChartRight, kConvergenceChartBottom}, kInk, 0.25);
  svg_line(svg, {kConvergenceChartLeft, kConvergenceChartTop},
           {kConvergenceChartLeft, kConvergenceChartBottom}, kInk, 0.25);
  svg_text(svg,
           {(kConvergenceChartLeft + kConvergenceChartRight) / 2, kConvergenceChartBottom + 10.5},
           3, Anchor::kMiddle, "Iteration");
  svg_text(svg, {4, (kConvergenceChartTop + kConvergenceChartBottom) / 2}, 3, Anchor::kMiddle,
           "mm (logarithmic)", false, true);
}

void draw_curve(SvgWriter& svg, const Column& column, const Curve& curve, const Plot& plot) {
  std::vector<Vec2> points;
  for (size_t i = 0; i < column.count(); ++i)
    if (const double decade = decade_of(column.number(i)); std::isfinite(decade))
      points.push_back({plot.x(static_cast<double>(i + 1)), plot.y(decade)});
  svg.leaf("path", {{"d", svg_polyline(points)},
                    {"fill", "none"},
                    {"stroke", curve.colour},
                    {"stroke-width", 0.5},
                    {"stroke-dasharray", *curve.dash != 0 ? curve.dash : "none"}});
  for (const Vec2& p : points)
    svg.leaf("circle", {{"cx", p.u}, {"cy", p.v}, {"r", 0.8}, {"fill", curve.colour}});
}

}  // namespace

std::string convergence_chart(const FieldTable& log) {
  if (log.find("rms") == nullptr || log.find("rms")->count() == 0) return {};
  SvgWriter svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox", "0 0 " + svg_number(kWidth) + " " + svg_number(kHeight)},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, "Convergence");
  const Plot plot = plot_of(log);
  draw_axes(svg, plot);
  double key = kConvergenceChartLeft;
  for (const Curve& curve : kCurves) {
    const Column* column = log.find(curve.column);
    if (column == nullptr) continue;
    draw_curve(svg, *column, curve, plot);
    svg_line(svg, {key, kConvergenceChartTop - 6}, {key + 7, kConvergenceChartTop - 6},
             curve.colour, 0.6);
    svg_text(svg, {key + 8.5, kConvergenceChartTop - 5}, kConvergenceChartText, Anchor::kStart,
             curve.name);
    key += 46;
  }
  return svg.take();
}

}  // namespace jalon
