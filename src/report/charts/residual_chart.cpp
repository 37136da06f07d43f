// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/residual_chart.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"
#include "report/charts/histogram_plot.h"

namespace jalon {

namespace {

constexpr double kResidualChartTop = 6;  // mm; the key of the curve stands in the plot
constexpr const char* kResidualChartCurve = "#b3472f";

void draw_curve(SvgWriter& svg, const Residuals& r, const HistogramPlot& plot) {
  constexpr int kSteps = 160;
  std::vector<Vec2> curve;
  for (int i = 0; i <= kSteps; ++i) {
    const double value = r.half_range_m * (2.0 * i / kSteps - 1);
    curve.push_back({plot.x(1000 * value), plot.y(r.expected(value))});
  }
  svg.leaf("path", {{"d", svg_polyline(curve)},
                    {"fill", "none"},
                    {"stroke", kResidualChartCurve},
                    {"stroke-width", 0.5}});
  svg_line(svg, {HistogramPlot::kRight - 48, kResidualChartTop + 2},
           {HistogramPlot::kRight - 40, kResidualChartTop + 2}, kResidualChartCurve, 0.5);
  svg_text(svg, {HistogramPlot::kRight - 38, kResidualChartTop + 3}, HistogramPlot::kText,
           Anchor::kStart, "normal, \xCF\x83 = " + text_of(1000 * r.sigma_m, 2) + " mm");
}

}  // namespace

std::string residual_chart(const Residuals& residuals) {
  SvgWriter svg;
  open_histogram(svg, "Histogram of the residuals");
  HistogramPlot plot{kResidualChartTop, -1000 * residuals.half_range_m,
                     1000 * residuals.half_range_m};
  for (const uint64_t n : residuals.bins) plot.most = std::max(plot.most, static_cast<double>(n));
  if (residuals.sigma_m > 0) plot.most = std::max(plot.most, residuals.expected(residuals.mean_m));
  plot.most *= 1.05;
  draw_axes(svg, plot, "Distance from the plane (mm)");
  draw_bars(svg, plot, residuals.bins);
  if (residuals.sigma_m > 0) draw_curve(svg, residuals, plot);
  return svg.take();
}

}  // namespace jalon
