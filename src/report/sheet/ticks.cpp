// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/sheet/ticks.h"

#include <algorithm>
#include <cmath>

#include "base/text_number.h"

namespace jalon {

namespace {

constexpr double kSlack = 1e-9;  // of a step: rounding of the multiples
constexpr size_t kMaxTicks = 1000;

}  // namespace

std::string Ticks::label(double value) const { return text_of(value, decimals); }

double round_up_125(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= value * (1 - kSlack)) return factor * power;
  return 10 * power;
}

Ticks make_ticks(double from, double to, double min_step) {
  Ticks ticks;
  if (!(to >= from) || !std::isfinite(to - from)) return ticks;
  const double floor_step =
      std::max({min_step, (to - from) / static_cast<double>(kMaxTicks), 1e-12});
  ticks.step = round_up_125(floor_step);
  ticks.decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(ticks.step) - kSlack)), 0, 12);
  const double first = std::ceil(from / ticks.step - kSlack);
  for (size_t k = 0; k < kMaxTicks; ++k) {
    const double value = (first + static_cast<double>(k)) * ticks.step;
    if (value > to + kSlack * ticks.step) break;
    ticks.values.push_back(value);
  }
  return ticks;
}

}  // namespace jalon
