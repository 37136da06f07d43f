// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "registration/targets/intensity_pattern.h"

namespace jalon {

/// How large a pattern is and how well it is one, to its border and beyond.
struct PatternExtent {
  double size_m = 0, sigma_m = 0;  ///< edge of a checker, diameter of a disc
  /// Share of the variance of the brightness, within the pattern and just around it, that neither the
  /// pattern on a uniform ground nor noise explains: 0 for what is one.
  double misfit = 1;
  double contrast_to_noise = 0;  ///< difference of bright and dark over the noise
  uint64_t points = 0;
  double round_chance = 1;  ///< of a disc: that its outline is one (disc_outline.h)
};

/// The border of four quadrants: where bright and dark ones end in the same ground, or where the
/// points end. Nothing where none is seen up to most_m.
///
/// Before: points relative to the centre; inner_m: edge of a square that lies within the pattern.
std::optional<PatternExtent> checker_extent(std::span<const BrightPoint> points, double inner_m,
                                            double most_m, Task& task);
/// Of a disc whose diameter is known; sigma_m: of that.
std::optional<PatternExtent> disc_extent(std::span<const BrightPoint> points, double diameter_m,
                                         double sigma_m);

}  // namespace jalon
