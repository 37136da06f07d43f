// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/time_scales.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kDay_s = 86400, kWeek_s = 7 * kDay_s;
constexpr double kTakenAway_s = 1e9;  // LAS 1.4, "adjusted standard GPS time"
constexpr double kMet = 0.9;          // of the shorter: a drive and its cloud share nearly all

bool meet(const TimeSpan& a, const TimeSpan& b, double shift_s) {
  const double common =
      std::min(a.last_s, b.last_s + shift_s) - std::max(a.first_s, b.first_s + shift_s);
  return common >= 0 && common >= kMet * std::min(a.last_s - a.first_s, b.last_s - b.first_s);
}

// The nearest of the shifts first + k * step that brings them together.
std::optional<double> nearest_shift(const TimeSpan& a, const TimeSpan& b, double first_s,
                                    double step_s) {
  const double apart = (a.first_s + a.last_s - b.first_s - b.last_s) / 2;
  const double k = std::round((apart - first_s) / step_s);
  for (const double off : {0.0, -1.0, 1.0})
    if (const double shift = first_s + (k + off) * step_s; meet(a, b, shift)) return shift;
  return {};
}

}  // namespace

std::optional<double> shift_between_scales(const TimeSpan& a, const TimeSpan& b) {
  if (const auto days = nearest_shift(a, b, 0, kDay_s)) return days;
  for (const double taken_s : {-kTakenAway_s, kTakenAway_s})
    if (const auto weeks = nearest_shift(a, b, taken_s, kWeek_s)) return weeks;
  return {};
}

}  // namespace jalon
