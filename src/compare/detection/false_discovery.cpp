// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/false_discovery.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace jalon {

double discovery_limit(std::vector<double> p_values, double rate) {
  std::sort(p_values.begin(), p_values.end());
  const auto m = static_cast<double>(p_values.size());
  for (size_t k = p_values.size(); k > 0; --k)
    if (p_values[k - 1] <= rate * static_cast<double>(k) / m) return p_values[k - 1];
  return -1;
}

double normal_p_value(double z) { return std::erfc(std::abs(z) / std::numbers::sqrt2); }

double deviate_of(double p) {
  if (!(p > 0)) return std::numeric_limits<double>::infinity();
  double low = 0, high = 40;  // beyond 38.5 p is no double
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (normal_p_value(middle) > p ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace jalon
