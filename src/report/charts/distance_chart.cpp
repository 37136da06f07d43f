// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/distance_chart.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"
#include "report/charts/histogram_plot.h"

namespace jalon {

namespace {

constexpr double kDistanceChartTop = 10,
                 kLine = 0.5;  // mm; the key of the curve stands above the plot
constexpr double kDistanceChartLeft = HistogramPlot::kLeft,
                 kDistanceChartRight = HistogramPlot::kRight,
                 kDistanceChartText = HistogramPlot::kText;
constexpr const char* kDistanceChartCurve = "#b3472f";
constexpr const char* kMark = "#1a1a1a";

std::string law_text(const NoiseLaw& law) {
  if (law.kind == LawKind::kWeibull)
    return "Weibull, a = " + text_of(law.shape, 2) + ", b = " + text_of(1000 * law.scale, 2) +
           " mm";
  return std::string(name_of(law.kind)) +
         ", \xCF\x83 = " + text_of(1000 * law.standard_deviation(), 2) + " mm";
}

// Expected points per bin at each place.
void draw_law(SvgWriter& svg, const Histogram& histogram, const NoiseLaw& law, double points,
              const HistogramPlot& plot) {
  constexpr int kSteps = 240;
  std::vector<Vec2> curve;
  for (int i = 0; i <= kSteps; ++i) {
    const double mm = plot.from_mm + (plot.to_mm - plot.from_mm) * i / kSteps;
    const double density = law.density(mm / 1000);
    if (std::isfinite(density))
      curve.push_back({plot.x(mm), plot.y(density * points * histogram.width())});
  }
  svg.leaf("path", {{"d", svg_polyline(curve)},
                    {"fill", "none"},
                    {"stroke", kDistanceChartCurve},
                    {"stroke-width", kLine}});
  svg_line(svg, {kDistanceChartRight - 68, kDistanceChartTop - 5},
           {kDistanceChartRight - 60, kDistanceChartTop - 5}, kDistanceChartCurve, kLine);
  svg_text(svg, {kDistanceChartRight - 58, kDistanceChartTop - 4}, kDistanceChartText,
           Anchor::kStart, law_text(law));
}

// What lies beyond the axis is counted at its ends.
void draw_tails(SvgWriter& svg, const Histogram& histogram, const HistogramPlot& plot) {
  const double row = HistogramPlot::kBottom - 9;  // above the low bars at the ends
  const auto tail = [&](uint64_t n, const char* where, double mm, double x, Anchor anchor) {
    if (n == 0) return;
    const double share = 100 * static_cast<double>(n) / static_cast<double>(histogram.values);
    svg_text(svg, {x, row}, kDistanceChartText, anchor,
             grouped(n) + where + text_of(mm, 1) + " mm (" + text_of(share, 2) + " %)", false,
             false, kGrey);
  };
  tail(histogram.above, " beyond ", plot.to_mm, kDistanceChartRight - 1, Anchor::kEnd);
  tail(histogram.below, " below ", plot.from_mm, kDistanceChartLeft + 1, Anchor::kStart);
}

void draw_marks(SvgWriter& svg, std::span<const ChartMark> marks, const HistogramPlot& plot) {
  double row = kDistanceChartTop + 3;
  for (const ChartMark& mark : marks) {
    const double mm = 1000 * mark.at_m;
    if (mm < plot.from_mm || mm > plot.to_mm) continue;
    svg.leaf("path", {{"d", svg_polyline(std::vector<Vec2>{{plot.x(mm), kDistanceChartTop},
                                                           {plot.x(mm), HistogramPlot::kBottom}})},
                      {"fill", "none"},
                      {"stroke", kMark},
                      {"stroke-width", 0.3},
                      {"stroke-dasharray", "1.5 1"}});
    const bool is_right = plot.x(mm) > (kDistanceChartLeft + kDistanceChartRight) / 2;
    svg_text(svg, {plot.x(mm) + (is_right ? -1 : 1), row}, kDistanceChartText,
             is_right ? Anchor::kEnd : Anchor::kStart, mark.name + " " + text_of(mm, 1) + " mm");
    row += 4;
  }
}

}  // namespace

std::string distance_chart(const Histogram& histogram, const NoiseLaw* law,
                           std::span<const ChartMark> marks, uint64_t law_values) {
  SvgWriter svg;
  open_histogram(svg, "Histogram of the distances");
  HistogramPlot plot{kDistanceChartTop, 1000 * histogram.from, 1000 * histogram.to};
  if (!(plot.to_mm > plot.from_mm)) plot.to_mm = plot.from_mm + 1;
  for (const uint64_t n : histogram.counts)
    plot.most = std::max(plot.most, 1.05 * static_cast<double>(n));
  draw_axes(svg, plot, "Distance (mm)");
  draw_bars(svg, plot, histogram.counts);
  if (law != nullptr)
    draw_law(svg, histogram, *law,
             static_cast<double>(law_values > 0 ? law_values : histogram.values), plot);
  draw_marks(svg, marks, plot);
  draw_tails(svg, histogram, plot);
  return svg.take();
}

}  // namespace jalon
