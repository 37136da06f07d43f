// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/residual_chart.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

// The plot's window in the chart's millimetres.
constexpr double kWidth = 180, kHeight = 80, kLeft = 20, kRight = 176, kTop = 6, kBottom = 66;
constexpr double kText = 2.8;
constexpr const char* kBar = "#65a8c4";
constexpr const char* kCurve = "#b3472f";

struct Plot {
  double half_range_mm, most;
  double x(double mm) const { return kLeft + (mm + half_range_mm) / (2 * half_range_mm) * (kRight - kLeft); }
  double y(double count) const { return kBottom - count / most * (kBottom - kTop); }
};

void draw_axes(SvgWriter& svg, const Plot& plot) {
  const Ticks x = make_ticks(-plot.half_range_mm, plot.half_range_mm, plot.half_range_mm / 6);
  for (const double mm : x.values) {
    svg_line(svg, {plot.x(mm), kBottom}, {plot.x(mm), kBottom + 1.5}, kInk, 0.2);
    svg_text(svg, {plot.x(mm), kBottom + 5}, kText, Anchor::kMiddle, x.label(mm));
  }
  const Ticks y = make_ticks(0, plot.most, std::max(plot.most / 6, 1.0));
  for (const double count : y.values) {
    svg_line(svg, {kLeft, plot.y(count)}, {kRight, plot.y(count)}, kFaint, 0.15);
    svg_text(svg, {kLeft - 1.5, plot.y(count) + 1}, kText, Anchor::kEnd, y.label(count));
  }
  svg_line(svg, {kLeft, kBottom}, {kRight, kBottom}, kInk, 0.25);
  svg_line(svg, {kLeft, kTop}, {kLeft, kBottom}, kInk, 0.25);
  svg_text(svg, {(kLeft + kRight) / 2, kBottom + 10.5}, 3, Anchor::kMiddle, "Distance from the plane (mm)");
  svg_text(svg, {4, (kTop + kBottom) / 2}, 3, Anchor::kMiddle, "Points per bin", false, true);
}

void draw_curve(SvgWriter& svg, const Residuals& r, const Plot& plot) {
  constexpr int kSteps = 160;
  std::vector<Vec2> curve;
  for (int i = 0; i <= kSteps; ++i) {
    const double value = r.half_range_m * (2.0 * i / kSteps - 1);
    curve.push_back({plot.x(1000 * value), plot.y(r.expected(value))});
  }
  svg.leaf("path", {{"d", svg_polyline(curve)}, {"fill", "none"}, {"stroke", kCurve}, {"stroke-width", 0.5}});
  svg_line(svg, {kRight - 48, kTop + 2}, {kRight - 40, kTop + 2}, kCurve, 0.5);
  svg_text(svg, {kRight - 38, kTop + 3}, kText, Anchor::kStart,
           "normal, \xCF\x83 = " + text_of(1000 * r.sigma_m, 2) + " mm");
}

}  // namespace

std::string residual_chart(const Residuals& residuals) {
  SvgWriter svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox", "0 0 " + svg_number(kWidth) + " " + svg_number(kHeight)},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, "Histogram of the residuals");
  Plot plot{1000 * residuals.half_range_m, 1};
  for (const uint64_t n : residuals.bins) plot.most = std::max(plot.most, static_cast<double>(n));
  if (residuals.sigma_m > 0) plot.most = std::max(plot.most, residuals.expected(residuals.mean_m));
  plot.most *= 1.05;
  draw_axes(svg, plot);
  const double bin_mm = 2 * plot.half_range_mm / static_cast<double>(residuals.bins.size());
  for (size_t i = 0; i < residuals.bins.size(); ++i) {
    if (residuals.bins[i] == 0) continue;
    const double from = -plot.half_range_mm + static_cast<double>(i) * bin_mm;
    const double top = plot.y(static_cast<double>(residuals.bins[i]));
    svg.leaf("rect", {{"x", plot.x(from)},
                      {"y", top},
                      {"width", plot.x(from + bin_mm) - plot.x(from)},
                      {"height", kBottom - top},
                      {"fill", kBar},
                      {"stroke", "#ffffff"},
                      {"stroke-width", 0.1}});
  }
  if (residuals.sigma_m > 0) draw_curve(svg, residuals, plot);
  return svg.take();
}

}  // namespace jalon
