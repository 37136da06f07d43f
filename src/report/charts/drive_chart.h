// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

namespace jalon {

/// A quantity along a drive, with its line in the chart.
struct DriveCurve {
  const char* name;
  const char* colour;
  bool is_dashed = false;
  std::vector<double> values_m;  ///< one a time; what is not finite leaves a gap
};

/// kFromZero: an axis that holds 0. kLogarithmic: for standard deviations, which an adjustment makes many times
/// smaller; values that are not positive leave a gap.
enum class DriveAxis { kFromZero, kLogarithmic };

/// Curves over the time of a drive as SVG, on one axis in millimetres; times ascend. "" without two times.
std::string drive_chart(const char* title, std::span<const double> times_s,
                        std::span<const DriveCurve> curves, DriveAxis axis);

}  // namespace jalon
