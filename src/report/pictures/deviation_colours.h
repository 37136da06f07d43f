// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "compare/comparison.h"
#include "formats/drawings/pixels.h"

namespace jalon {

/// Colours of distances: signed ones from blue over white to red, unsigned ones from pale yellow to dark red; what lies
/// beyond the ends has their colours. Both can be told apart with red-green blindness and in print (Brewer 2003).
struct DeviationScale {
  double limit_m = 1;  ///< at the end of the scale
  bool is_signed = false;
  static constexpr uint32_t kSteps = 64;

  Rgb colour(uint32_t step) const;
  uint32_t step_of(double distance_m) const;  ///< 0 ... kSteps - 1
  double lowest_m() const { return is_signed ? -limit_m : 0; }
};

/// share 0: a, 1: b; from 0 to 1.
Rgb mixed(const Rgb& a, const Rgb& b, double share);

constexpr Rgb kHiddenColour{0xf2, 0xa3, 0xd0}, kNotComparedColour{0xb4, 0xb4, 0xb4};

/// For these comparisons together: 98 % of the sizes lie within, rounded up to 1, 2 or 5; limit_m above 0 is taken as
/// it is. Signed when a distance is below zero.
DeviationScale deviation_scale(std::span<const Comparison* const> comparisons, double limit_m);

}  // namespace jalon
