// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "report/sheet/svg_parts.h"

namespace jalon {

/// Window of a histogram of distances: their millimetres to the right, points a bin upward; the rest
/// is in millimetres of the chart.
struct HistogramPlot {
  static constexpr double kWidth = 180, kHeight = 80, kLeft = 20, kRight = 176, kBottom = 66,
                          kText = 2.8;

  double top, from_mm, to_mm, most = 1;
  double x(double mm) const {
    return kLeft + (mm - from_mm) / (to_mm - from_mm) * (kRight - kLeft);
  }
  double y(double count) const { return kBottom - std::min(count / most, 1.0) * (kBottom - top); }
};

/// Opens the chart: the svg element and its title.
void open_histogram(SvgWriter& svg, const char* title);
/// Axes with tick marks, labels and their names; what: the name of the axis to the right.
void draw_axes(SvgWriter& svg, const HistogramPlot& plot, const char* what);
/// A bar a bin that holds points; bins of equal width from from_mm to to_mm.
void draw_bars(SvgWriter& svg, const HistogramPlot& plot, std::span<const uint64_t> bins);

}  // namespace jalon
