// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/histogram_plot.h"

#include "report/sheet/ticks.h"

namespace jalon {

namespace {

constexpr double kHistogramPlotLeft = HistogramPlot::kLeft,
                 kHistogramPlotRight = HistogramPlot::kRight,
                 kHistogramPlotBottom = HistogramPlot::kBottom;
constexpr double kHistogramPlotText = HistogramPlot::kText;
constexpr const char* kBar = "#65a8c4";

}  // namespace

void open_histogram(SvgWriter& svg, const char* title) {
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox", "0 0 " + svg_number(HistogramPlot::kWidth) + " " +
                                   svg_number(HistogramPlot::kHeight)},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, title);
}

void draw_axes(SvgWriter& svg, const HistogramPlot& plot, const char* what) {
  const Ticks x = make_ticks(plot.from_mm, plot.to_mm, (plot.to_mm - plot.from_mm) / 12);
  for (const double mm : x.values) {
    svg_line(svg, {plot.x(mm), kHistogramPlotBottom}, {plot.x(mm), kHistogramPlotBottom + 1.5},
             kInk, 0.2);
    svg_text(svg, {plot.x(mm), kHistogramPlotBottom + 5}, kHistogramPlotText, Anchor::kMiddle,
             x.label(mm));
  }
  const Ticks y = make_ticks(0, plot.most, std::max(plot.most / 6, 1.0));
  for (const double count : y.values) {
    svg_line(svg, {kHistogramPlotLeft, plot.y(count)}, {kHistogramPlotRight, plot.y(count)}, kFaint,
             0.15);
    svg_text(svg, {kHistogramPlotLeft - 1.5, plot.y(count) + 1}, kHistogramPlotText, Anchor::kEnd,
             y.label(count));
  }
  svg_line(svg, {kHistogramPlotLeft, kHistogramPlotBottom},
           {kHistogramPlotRight, kHistogramPlotBottom}, kInk, 0.25);
  svg_line(svg, {kHistogramPlotLeft, plot.top}, {kHistogramPlotLeft, kHistogramPlotBottom}, kInk,
           0.25);
  svg_text(svg, {(kHistogramPlotLeft + kHistogramPlotRight) / 2, kHistogramPlotBottom + 10.5}, 3,
           Anchor::kMiddle, what);
  svg_text(svg, {4, (plot.top + kHistogramPlotBottom) / 2}, 3, Anchor::kMiddle, "Points per bin",
           false, true);
}

void draw_bars(SvgWriter& svg, const HistogramPlot& plot, std::span<const uint64_t> bins) {
  const double bin_mm =
      (plot.to_mm - plot.from_mm) / static_cast<double>(std::max<size_t>(1, bins.size()));
  for (size_t i = 0; i < bins.size(); ++i) {
    if (bins[i] == 0) continue;
    const double from = plot.from_mm + static_cast<double>(i) * bin_mm,
                 top = plot.y(static_cast<double>(bins[i]));
    svg.leaf("rect", {{"x", plot.x(from)},
                      {"y", top},
                      {"width", plot.x(from + bin_mm) - plot.x(from)},
                      {"height", kHistogramPlotBottom - top},
                      {"fill", kBar},
                      {"stroke", "#ffffff"},
                      {"stroke-width", 0.1}});
  }
}

}  // namespace jalon
