// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/distance_chart.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

// The plot's window in the chart's millimetres.
constexpr double kWidth = 180, kHeight = 80, kLeft = 20, kRight = 176, kTop = 10, kBottom = 66;
constexpr double kText = 2.8, kLine = 0.5;
constexpr const char* kBar = "#65a8c4";
constexpr const char* kCurve = "#b3472f";
constexpr const char* kMark = "#1a1a1a";

struct Plot {
  double from_mm, to_mm, most;
  double x(double mm) const { return kLeft + (mm - from_mm) / (to_mm - from_mm) * (kRight - kLeft); }
  double y(double count) const { return kBottom - std::min(count / most, 1.0) * (kBottom - kTop); }
};

void draw_axes(SvgWriter& svg, const Plot& plot) {
  const Ticks x = make_ticks(plot.from_mm, plot.to_mm, (plot.to_mm - plot.from_mm) / 12);
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
  svg_text(svg, {(kLeft + kRight) / 2, kBottom + 10.5}, 3, Anchor::kMiddle, "Distance (mm)");
  svg_text(svg, {4, (kTop + kBottom) / 2}, 3, Anchor::kMiddle, "Points per bin", false, true);
}

std::string law_text(const NoiseLaw& law) {
  if (law.kind == LawKind::kWeibull)
    return "Weibull, a = " + text_of(law.shape, 2) + ", b = " + text_of(1000 * law.scale, 2) + " mm";
  return std::string(name_of(law.kind)) + ", \xCF\x83 = " + text_of(1000 * law.standard_deviation(), 2) + " mm";
}

// Expected points per bin at each place.
void draw_law(SvgWriter& svg, const Histogram& histogram, const NoiseLaw& law, const Plot& plot) {
  constexpr int kSteps = 240;
  std::vector<Vec2> curve;
  const double points = static_cast<double>(histogram.values) * histogram.width();
  for (int i = 0; i <= kSteps; ++i) {
    const double mm = plot.from_mm + (plot.to_mm - plot.from_mm) * i / kSteps;
    const double density = law.density(mm / 1000);
    if (std::isfinite(density)) curve.push_back({plot.x(mm), plot.y(density * points)});
  }
  svg.leaf("path", {{"d", svg_polyline(curve)}, {"fill", "none"}, {"stroke", kCurve}, {"stroke-width", kLine}});
  svg_line(svg, {kRight - 68, kTop - 5}, {kRight - 60, kTop - 5}, kCurve, kLine);
  svg_text(svg, {kRight - 58, kTop - 4}, kText, Anchor::kStart, law_text(law));
}

void draw_marks(SvgWriter& svg, std::span<const ChartMark> marks, const Plot& plot) {
  double row = kTop + 3;
  for (const ChartMark& mark : marks) {
    const double mm = 1000 * mark.at_m;
    if (mm < plot.from_mm || mm > plot.to_mm) continue;
    svg.leaf("path", {{"d", svg_polyline(std::vector<Vec2>{{plot.x(mm), kTop}, {plot.x(mm), kBottom}})},
                      {"fill", "none"}, {"stroke", kMark}, {"stroke-width", 0.3}, {"stroke-dasharray", "1.5 1"}});
    const bool is_right = plot.x(mm) > (kLeft + kRight) / 2;
    svg_text(svg, {plot.x(mm) + (is_right ? -1 : 1), row}, kText, is_right ? Anchor::kEnd : Anchor::kStart,
             mark.name + " " + text_of(mm, 1) + " mm");
    row += 4;
  }
}

}  // namespace

std::string distance_chart(const Histogram& histogram, const NoiseLaw* law, std::span<const ChartMark> marks) {
  SvgWriter svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox", "0 0 " + svg_number(kWidth) + " " + svg_number(kHeight)},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, "Histogram of the distances");
  Plot plot{1000 * histogram.from, 1000 * histogram.to, 1};
  if (!(plot.to_mm > plot.from_mm)) plot.to_mm = plot.from_mm + 1;
  for (const uint64_t n : histogram.counts) plot.most = std::max(plot.most, 1.05 * static_cast<double>(n));
  draw_axes(svg, plot);
  const double bin_mm = (plot.to_mm - plot.from_mm) / static_cast<double>(std::max<size_t>(1, histogram.counts.size()));
  for (size_t i = 0; i < histogram.counts.size(); ++i) {
    if (histogram.counts[i] == 0) continue;
    const double from = plot.from_mm + static_cast<double>(i) * bin_mm;
    const double top = plot.y(static_cast<double>(histogram.counts[i]));
    svg.leaf("rect", {{"x", plot.x(from)}, {"y", top}, {"width", plot.x(from + bin_mm) - plot.x(from)},
                      {"height", kBottom - top}, {"fill", kBar}, {"stroke", "#ffffff"}, {"stroke-width", 0.1}});
  }
  if (law != nullptr) draw_law(svg, histogram, *law, plot);
  draw_marks(svg, marks, plot);
  return svg.take();
}

}  // namespace jalon
