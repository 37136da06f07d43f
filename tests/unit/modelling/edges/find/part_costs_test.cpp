// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What straight and curved parts of a chain cost.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "modelling/edges/find/part_costs.h"

using namespace jalon;

namespace {

// Points a spacing apart on a circle about the origin, from one angle on.
std::vector<Vec2> on_circle(double radius, double from, double turn) {
  std::vector<Vec2> out;
  const auto n = static_cast<size_t>(radius * turn);
  for (size_t k = 0; k <= n; ++k) {
    const double a = from + turn * static_cast<double>(k) / static_cast<double>(n);
    out.push_back({radius * std::cos(a), radius * std::sin(a)});
  }
  return out;
}

}  // namespace

TEST_CASE("part_costs__a_line_on_a_row_and_an_arc_on_a_round_head_cost_their_parameters") {
  std::vector<Vec2> row;
  for (int k = 0; k <= 50; ++k) row.push_back({k + 0.0, 0});
  const PartsSetting setting{1, true};
  const PartCosts straight(row, setting);
  const PartCost line = cost_of(straight, 0, 50);
  CHECK(!line.is_arc);
  CHECK(line.cost == doctest::Approx(51 + straight.line_cost));

  const std::vector<Vec2> head = on_circle(20, 0, std::numbers::pi);
  const PartCosts round(head, setting);
  const PartCost arc = cost_of(round, 0, head.size() - 1);
  CHECK(arc.is_arc);
  CHECK(arc.cost == doctest::Approx(static_cast<double>(head.size()) + round.arc_cost));
  CHECK(swept(round, {{0, 0}, 20}, 0, head.size() - 1) == doctest::Approx(std::numbers::pi));
}

TEST_CASE("part_costs__of_an_arc_grow_from_a_level_chord_to_an_upright_one_but_not_of_a_circle") {
  const PartsSetting setting{1, true};
  double before = 0;
  for (const double turned : {0.0, 0.3, 0.8, 1.2, 0.5 * std::numbers::pi}) {
    CAPTURE(turned);
    const std::vector<Vec2> chain = on_circle(20, turned, std::numbers::pi);
    const PartCosts costs(chain, setting);
    const PartCost arc = cost_of(costs, 0, chain.size() - 1);
    REQUIRE(arc.is_arc);
    const double more = arc.cost - static_cast<double>(chain.size()) - costs.arc_cost;
    CHECK(more == doctest::Approx(2 * costs.line_cost * std::pow(std::sin(turned), 2)));
    CHECK(more >= before);
    before = more;
  }
  std::vector<Vec2> circle = on_circle(20, 1, 2 * std::numbers::pi);
  circle.pop_back();
  const PartCosts costs(circle, setting);
  const PartCost whole = cost_of(costs, 0, circle.size());
  CHECK(whole.is_arc);
  CHECK(whole.cost == doctest::Approx(static_cast<double>(circle.size() + 1) + costs.arc_cost));
}

TEST_CASE("part_costs__a_part_far_from_a_line_and_from_an_arc_is_not_worth_extending") {
  std::vector<Vec2> corner;
  for (int k = 0; k < 40; ++k) corner.push_back({k + 0.0, 0});
  for (int k = 0; k < 40; ++k) corner.push_back({40, k + 0.0});
  const PartsSetting lines{1, false};
  const PartCosts costs(corner, lines);
  CHECK(cost_of(costs, 0, 79).is_hopeless);
  CHECK(!cost_of(costs, 0, 39).is_hopeless);
  CHECK(is_hopeless(1e3 * 79, 79));
  CHECK(!is_hopeless(79, 79));
}
