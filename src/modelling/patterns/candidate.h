// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "modelling/patterns/grid.h"
#include "modelling/patterns/place.h"

namespace jalon {

/// Sides of a form in the order of Placement::sides.
enum PatternSide : uint8_t { kLeft, kRight, kLower, kUpper };

/// Where a copy could go.
struct PatternCandidate {
  size_t pattern = 0;
  Motion2 motion;
  size_t signs = 0;  ///< sides seen and lines of the grid agreed with; 0: it is not there
  double residual_m = 0, cost_m2 = 0;
  std::vector<Vec2> border;  ///< what it was judged by
  double parameters =
      2;  ///< of its place, less those that lines of the grid confirm; more for an odd one in a row

  /// The less the likelier: Schwarz' criterion (1978), per border point.
  double unlikeliness() const;
  bool is_likelier_than(const PatternCandidate& other) const {
    return signs > 0 && (other.signs == 0 || unlikeliness() < other.unlikeliness());
  }
};

/// Whether an outline of so many parameters, this far from the same border points (mean square),
/// says so much more about them than the copy does that its parameters are worth it. Before: copy
/// has a border.
bool is_better_explained(const PatternCandidate& copy, double own_cost_m2, double own_parameters);

/// Variance of a placement across two opposite sides by those that are seen; infinite when none is. spacing_m: of the
/// wall's points there.
double variance_across(const Placement& placed, const std::array<bool, 4>& seen, PatternSide a,
                       PatternSide b, double spacing_m);

/// From where the border has the middle of a copy, with this variance, towards its line of the grid: the mean weighted
/// by the variances of both. Not at all without a line or when the two contradict each other.
double step_to_line(const OpeningGrid& grid, const GridLine* line, double at_m, double border_m2);

}  // namespace jalon
