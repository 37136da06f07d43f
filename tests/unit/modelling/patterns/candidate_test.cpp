// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// How likely a copy is, and where its border and the grid put it.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/patterns/candidate.h"

using namespace jalon;

namespace {

PatternCandidate candidate(double cost_m2, size_t points, double parameters) {
  PatternCandidate out;
  out.signs = 1;
  out.cost_m2 = cost_m2;
  out.border.resize(points);
  out.parameters = parameters;
  return out;
}

}  // namespace

TEST_CASE("candidate__is_likelier_with_a_better_fit_fewer_parameters_and_any_sign") {
  const PatternCandidate good = candidate(1e-4, 40, 2), poor = candidate(4e-4, 40, 2),
                         odd = candidate(1e-4, 40, 3);
  CHECK(good.is_likelier_than(poor));
  CHECK(!poor.is_likelier_than(good));
  CHECK(good.is_likelier_than(odd));
  PatternCandidate unseen = candidate(1e-8, 40, 0);
  unseen.signs = 0;
  CHECK(poor.is_likelier_than(unseen));
  CHECK(!unseen.is_likelier_than(poor));
  // Exact data say no more than a tenth of a millimetre does.
  CHECK(candidate(0, 40, 2).unlikeliness() == candidate(1e-9, 40, 2).unlikeliness());
}

TEST_CASE("candidate__more_parameters_must_pay_by_the_logarithm_of_the_points") {
  // Schwarz: n ln(copy / own) against (difference of parameters) ln(n).
  const PatternCandidate copy = candidate(4e-4, 20, 2);
  const double even_m2 = 4e-4 * std::exp(-3 * std::log(20.0) / 20);
  CHECK(is_better_explained(copy, 0.99 * even_m2, 5));
  CHECK(!is_better_explained(copy, 1.01 * even_m2, 5));
  CHECK(is_better_explained(copy, 1.01 * even_m2, 3));
}

TEST_CASE("candidate__two_sides_seen_fix_a_place_better_than_one_and_none_not_at_all") {
  Placement placed;
  placed.residual_m = 0.01;
  placed.sides = {25, 25, 100, 0};
  const double both = variance_across(placed, {true, true, false, false}, kLeft, kRight, 0.02);
  const double one = variance_across(placed, {true, false, false, false}, kLeft, kRight, 0.02);
  CHECK(both == doctest::Approx(one / 2));
  CHECK(one > 1e-4 / 25);
  CHECK(variance_across(placed, {true, true, false, false}, kLower, kUpper, 0.02) == INFINITY);
  CHECK(variance_across(placed, {true, true, true, false}, kLower, kUpper, 0.02) < one);
}

TEST_CASE("candidate__goes_to_its_line_by_the_weights_of_border_and_grid") {
  OpeningGrid grid;
  grid.sigma_m = 0.01;
  const GridLine line{5, {0, 1, 2, 3}};
  const double line_m2 = 1e-4 * 1.25;
  CHECK(grid.variance_m2(line) == doctest::Approx(line_m2));
  CHECK(step_to_line(grid, nullptr, 4.9, 1e-4) == 0);
  CHECK(step_to_line(grid, &line, 4.9, INFINITY) == doctest::Approx(0.1));   // the line alone
  CHECK(step_to_line(grid, &line, 4.98, line_m2) == doctest::Approx(0.01));  // half way
  CHECK(step_to_line(grid, &line, 4.98, 1e-12) < 1e-8);
  CHECK(step_to_line(grid, &line, 4.9, line_m2) == 0);  // they contradict each other
}
