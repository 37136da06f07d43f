// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "base/random.h"

namespace jalon::grammar {

/// What is left to chance, drawn one after the other from one stream.
class Dice {
 public:
  Dice(uint64_t seed, uint64_t stream) : random_(seed, stream) {}

  double between(double from, double to) { return from + (to - from) * random_.uniform(); }
  /// A multiple of the step, as builders measure.
  double length(double from_m, double to_m, double step_m = 0.05) {
    return std::round(between(from_m, to_m) / step_m) * step_m;
  }
  int count(int from, int to) {
    return from + static_cast<int>(random_.below(static_cast<uint64_t>(to - from + 1)));
  }
  bool chance(double share) { return random_.uniform() < share; }
  /// Evenly spread in its logarithm.
  double scale(double from, double to) { return from * std::pow(to / from, random_.uniform()); }

 private:
  RandomStream random_;
};

}  // namespace jalon::grammar
