// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/drive_chart.h"

#include <algorithm>
#include <cmath>

#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

// The plot's window in the chart's millimetres.
constexpr double kDriveWidth = 180, kDriveHeight = 84, kDriveLeft = 22, kDriveRight = 176,
                 kDriveTop = 12, kDriveBottom = 70, kDriveText = 2.8;

struct DrivePlot {
  double from_s, to_s;
  DriveAxis axis;
  double low = INFINITY, high = -INFINITY;  ///< of heights

  // What is drawn upward: millimetres or their decades; NaN where there is none.
  double height(double mm) const {
    if (axis == DriveAxis::kFromZero) return mm;
    return mm > 0 ? std::log10(mm) : NAN;
  }
  double x(double time_s) const {
    return kDriveLeft + (time_s - from_s) / (to_s - from_s) * (kDriveRight - kDriveLeft);
  }
  double y(double mm) const {
    return kDriveBottom - (height(mm) - low) / (high - low) * (kDriveBottom - kDriveTop);
  }
};

DrivePlot drive_plot_of(std::span<const double> times_s, std::span<const DriveCurve> curves,
                        DriveAxis axis) {
  DrivePlot plot{times_s.front(), times_s.back(), axis};
  for (const DriveCurve& curve : curves)
    for (const double value : curve.values_m)
      if (const double height = plot.height(1000 * value); std::isfinite(height)) {
        plot.low = std::min(plot.low, height);
        plot.high = std::max(plot.high, height);
      }
  if (plot.low > plot.high) plot.low = plot.high = 0;  // no value at all
  if (axis == DriveAxis::kLogarithmic) {
    plot.low = std::floor(plot.low);
    plot.high = std::max(std::ceil(plot.high), plot.low + 1);
    return plot;
  }
  plot.low = std::min(plot.low, 0.0), plot.high = std::max(plot.high, 0.0);
  constexpr double kAir = 0.05;  // above and below the curves
  const double range = std::max(plot.high - plot.low, 1e-3);
  if (plot.low < 0) plot.low -= kAir * range;
  plot.high += kAir * range;
  return plot;
}

void draw_drive_level(SvgWriter& svg, const DrivePlot& plot, double mm, const std::string& label) {
  svg_line(svg, {kDriveLeft, plot.y(mm)}, {kDriveRight, plot.y(mm)}, mm == 0 ? kGrey : kFaint,
           0.15);
  svg_text(svg, {kDriveLeft - 1.5, plot.y(mm) + 1}, kDriveText, Anchor::kEnd, label);
}

void draw_drive_levels(SvgWriter& svg, const DrivePlot& plot) {
  constexpr double kLevels = 8;  // at most so many
  if (plot.axis == DriveAxis::kFromZero) {
    const Ticks levels = make_ticks(plot.low, plot.high, (plot.high - plot.low) / kLevels);
    for (const double mm : levels.values) draw_drive_level(svg, plot, mm, levels.label(mm));
    return;
  }
  for (double decade = plot.low; decade <= plot.high; ++decade)
    for (const double step : {1.0, 2.0, 5.0}) {
      const bool is_between = step > 1;
      if (is_between && (decade == plot.high || plot.high - plot.low > 3)) continue;
      draw_drive_level(svg, plot, step * std::pow(10, decade),
                       svg_number(step * std::pow(10, decade)));
    }
}

void draw_drive_axes(SvgWriter& svg, const DrivePlot& plot) {
  constexpr double kMarks = 10;  // at most so many
  draw_drive_levels(svg, plot);
  // GPS seconds of a week are long numbers that hardly differ: the axis counts from the start.
  const Ticks marks = make_ticks(0, plot.to_s - plot.from_s, (plot.to_s - plot.from_s) / kMarks);
  for (const double s : marks.values) {
    const double x = plot.x(plot.from_s + s);
    svg_line(svg, {x, kDriveBottom}, {x, kDriveBottom + 1.5}, kInk, 0.2);
    svg_text(svg, {x, kDriveBottom + 5}, kDriveText, Anchor::kMiddle, marks.label(s));
  }
  svg_line(svg, {kDriveLeft, kDriveBottom}, {kDriveRight, kDriveBottom}, kInk, 0.25);
  svg_line(svg, {kDriveLeft, kDriveTop}, {kDriveLeft, kDriveBottom}, kInk, 0.25);
  svg_text(svg, {(kDriveLeft + kDriveRight) / 2, kDriveBottom + 10.5}, 3, Anchor::kMiddle,
           "Time since the start (s)");
  svg_text(svg, {4, (kDriveTop + kDriveBottom) / 2}, 3, Anchor::kMiddle,
           plot.axis == DriveAxis::kLogarithmic ? "mm (logarithmic)" : "mm", false, true);
}

// Thins to what the width can show: the line of hours at 100 Hz would be megabytes.
void draw_drive_curve(SvgWriter& svg, const DrivePlot& plot, std::span<const double> times_s,
                      const DriveCurve& curve) {
  constexpr size_t kMostPoints = 1500;
  const size_t stride = std::max<size_t>(1, times_s.size() / kMostPoints);
  std::vector<Vec2> line;
  const auto flush = [&] {
    if (line.size() > 1)
      svg.leaf("path", {{"d", svg_polyline(line)},
                        {"fill", "none"},
                        {"stroke", curve.colour},
                        {"stroke-width", 0.5},
                        {"stroke-dasharray", curve.is_dashed ? "1.5 1" : "none"}});
    line.clear();
  };
  for (size_t i = 0; i < times_s.size(); i += stride) {
    if (std::isfinite(plot.height(1000 * curve.values_m[i])))
      line.push_back({plot.x(times_s[i]), plot.y(1000 * curve.values_m[i])});
    else flush();
  }
  flush();
}

}  // namespace

std::string drive_chart(const char* title, std::span<const double> times_s,
                        std::span<const DriveCurve> curves, DriveAxis axis) {
  if (times_s.size() < 2) return {};
  SvgWriter svg;
  svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                   {"viewBox", "0 0 " + svg_number(kDriveWidth) + " " + svg_number(kDriveHeight)},
                   {"font-family", "Helvetica, Arial, sans-serif"}});
  svg.element("title", {}, title);
  const DrivePlot plot = drive_plot_of(times_s, curves, axis);
  draw_drive_axes(svg, plot);
  double key = kDriveLeft;
  for (const DriveCurve& curve : curves) {
    draw_drive_curve(svg, plot, times_s, curve);
    svg.leaf(
        "path",
        {{"d", svg_polyline(std::vector<Vec2>{{key, kDriveTop - 6}, {key + 7, kDriveTop - 6}})},
         {"fill", "none"},
         {"stroke", curve.colour},
         {"stroke-width", 0.6},
         {"stroke-dasharray", curve.is_dashed ? "1.5 1" : "none"}});
    svg_text(svg, {key + 8.5, kDriveTop - 5}, kDriveText, Anchor::kStart, curve.name);
    key += 12 + text_width(curve.name, kDriveText);
  }
  return svg.take();
}

}  // namespace jalon
