// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/patterns/candidate.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kLeastCost_m2 = 1e-8;  // 0.1 mm squared: exact data
constexpr double kSetBackSigma =
    0.15;  // local spacings: of the last points' mean distance from a side
constexpr double kContradiction = 3;  // sigma

}  // namespace

double PatternCandidate::unlikeliness() const {
  const auto n = static_cast<double>(std::max<size_t>(2, border.size()));
  return std::log(std::max(cost_m2, kLeastCost_m2)) + parameters * std::log(n) / n;
}

bool is_better_explained(const PatternCandidate& copy, double own_cost_m2, double own_parameters) {
  const auto n = static_cast<double>(copy.border.size());
  return n * std::log(copy.cost_m2 / std::max(own_cost_m2, kLeastCost_m2)) >
         (own_parameters - copy.parameters) * std::log(n);
}

double variance_across(const Placement& placed, const std::array<bool, 4>& seen, PatternSide a,
                       PatternSide b, double spacing_m) {
  const double set_back_m = kSetBackSigma * spacing_m;
  double sum = 0, count = 0;
  for (const PatternSide s : {a, b}) {
    if (!seen[s]) continue;
    const auto points = static_cast<double>(std::max<size_t>(1, placed.sides[s]));
    sum += placed.residual_m * placed.residual_m / points + set_back_m * set_back_m;
    ++count;
  }
  return count > 0 ? sum / (count * count) : INFINITY;
}

double step_to_line(const OpeningGrid& grid, const GridLine* line, double at_m, double border_m2) {
  if (line == nullptr) return 0;
  const double way_m = line->at - at_m, both_m2 = border_m2 + grid.variance_m2(*line);
  if (!(border_m2 < INFINITY)) return way_m;
  return way_m * way_m <= kContradiction * kContradiction * both_m2 ? way_m * border_m2 / both_m2
                                                                    : 0;
}

}  // namespace jalon
