// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace jalon {

/// Marks of an axis: multiples of 1, 2 or 5 times a power of ten.
struct Ticks {
  double step = 1;
  int decimals = 0;            ///< that tell the marks apart
  std::vector<double> values;  ///< within [from, to], ascending; at most 1000
  std::string label(double value) const;
};

/// The finest such marks in [from, to] that are at least min_step apart.
Ticks make_ticks(double from, double to, double min_step);

/// The smallest 1, 2 or 5 times a power of ten that is >= value; value > 0.
double round_up_125(double value);

}  // namespace jalon
