// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fieldtools/histogram.h"

namespace jalon {

/// A threshold on the chart.
struct ChartMark {
  double at_m = 0;
  std::string name;
};

/// Histogram of distances as SVG: millimetres across, points upward, the fitted law as a curve, thresholds as lines.
/// What lies beyond the axis is counted at its ends. law may be null; law_values: how many values it stands for,
/// 0 = all.
std::string distance_chart(const Histogram& histogram, const NoiseLaw* law,
                           std::span<const ChartMark> marks, uint64_t law_values = 0);

}  // namespace jalon
