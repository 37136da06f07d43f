// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace jalon {

struct TimeSpan {
  double first_s = 0, last_s = 0;
};

/// By how much the times of b have to grow so that it meets a, which it does not, where they tell the time by scales
/// that differ by what is known: whole days (seconds of a day beside those of a GPS week) or 1e9 s less whole weeks
/// (seconds of a GPS week beside the adjusted standard time of LAS). None where neither brings them together.
std::optional<double> shift_between_scales(const TimeSpan& a, const TimeSpan& b);

}  // namespace jalon
