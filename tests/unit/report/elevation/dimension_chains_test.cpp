// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Chains of random openings: what must hold of every chain, and places known from a grid that scatters.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "report/elevation/dimension_chains.h"

using namespace jalon;

namespace {

constexpr double kChainTolerance_m = 0.05;

OpeningBox chain_box(double u, double v, double width, double height) {
  return {{u, v}, {u + width, v + height}};
}

void check_chain(const OpeningChain& chain, double from, double to) {
  for (size_t i = 1; i < chain.openings.size(); ++i)
    CHECK(chain.openings[i].from >= chain.openings[i - 1].to);
  for (const auto& places : {chain.sides(), chain.axes()}) {
    if (chain.openings.empty()) {
      CHECK(places.empty());
      continue;
    }
    REQUIRE(places.size() >= 2);
    CHECK(places.front() == from);
    CHECK(places.back() == to);
    for (size_t i = 1; i < places.size(); ++i) CHECK(places[i] - places[i - 1] > kChainTolerance_m);
  }
}

}  // namespace

TEST_CASE("dimension_chains__run_from_end_to_end_in_steps_that_can_be_told_apart") {
  RandomStream random(1, 0);
  for (int trial = 0; trial < 200; ++trial) {
    CAPTURE(trial);
    std::vector<OpeningBox> boxes;
    for (uint64_t n = random.below(30); n > 0; --n)
      boxes.push_back(chain_box(11 * random.uniform() - 0.5, 6 * random.uniform(),
                                0.1 + 2 * random.uniform(), 0.1 + 2 * random.uniform()));
    const Dimensions d = find_dimensions(boxes, {}, {{0, 0}, {10, 8}}, 0.2, kChainTolerance_m);
    check_chain(d.columns, 0, 10);
    check_chain(d.ground_floor, 0, 10);
    check_chain(d.rows, 0, 8);
    for (size_t i = 0; i < d.levels.size(); ++i)
      for (size_t k = 0; k < i; ++k)
        CHECK(std::fabs(d.levels[i] - d.levels[k]) > kChainTolerance_m);
    REQUIRE(d.levels.size() >= 2);
    CHECK(d.levels[0] == 0.2);
    CHECK(d.levels[1] == 8);
  }
}

TEST_CASE("dimension_chains__columns_stand_at_the_mean_of_their_openings") {
  // Three columns of forty openings whose sides scatter by 5 mm; the tolerance is ten sigma.
  RandomStream random(2, 0);
  std::vector<OpeningBox> boxes;
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 3; ++column)
      boxes.push_back(chain_box(1 + 3 * column + 0.005 * random.normal(), 1 + 3 * row,
                                1.2 + 0.005 * random.normal(), 1.5));
  const Dimensions d = find_dimensions(boxes, {}, {{0, 0}, {10, 125}}, 0, kChainTolerance_m);
  REQUIRE(d.columns.openings.size() == 3);
  const double limit = 4 * 0.005 / std::sqrt(39.0);  // the lowest row has its own chain
  for (size_t i = 0; i < 3; ++i) {
    const double u = 1 + 3 * static_cast<double>(i);
    CHECK(d.columns.openings[i].count == 39);
    CHECK(std::fabs(d.columns.openings[i].from - u) < limit);
    CHECK(std::fabs(d.columns.openings[i].to - u - 1.2) < std::sqrt(2.0) * limit);
    CHECK(d.axes[i + 1] ==
          doctest::Approx((d.columns.openings[i].from + d.columns.openings[i].to) / 2));
  }
  CHECK(d.rows.openings.size() == 40);
  CHECK(d.ground_floor.openings.empty());  // the same columns within the tolerance
}

TEST_CASE("dimension_chains__the_ground_floor_has_its_own_where_it_differs") {
  std::vector<OpeningBox> boxes{chain_box(1, 4, 1, 1),       chain_box(4, 4, 1, 1),
                                chain_box(1, 7, 1, 1),       chain_box(4, 7, 1, 1),
                                chain_box(0.8, 0, 1.4, 2.5), chain_box(4, 1, 1, 1)};
  const Dimensions d = find_dimensions(boxes, {}, {{0, 0}, {6, 9}}, 0, kChainTolerance_m);
  CHECK(d.columns.sides() == std::vector<double>{0, 1, 2, 4, 5, 6});
  REQUIRE(d.ground_floor.openings.size() == 2);  // the door, and the window beside it
  CHECK(d.ground_floor.openings[0].from == 0.8);
  CHECK(d.ground_floor.openings[0].to == doctest::Approx(2.2));
  CHECK(d.ground_floor.openings[1].from == 4);
  // One row alone is the columns.
  const Dimensions row =
      find_dimensions(std::span(boxes).last(2), {}, {{0, 0}, {6, 9}}, 0, kChainTolerance_m);
  CHECK(row.columns.openings.size() == 2);
  CHECK(row.ground_floor.openings.empty());
}

TEST_CASE("dimension_chains__the_narrowest_opening_goes_first_and_cornices_give_levels") {
  const std::vector<OpeningBox> boxes{chain_box(1, 1, 1.2, 1), chain_box(4, 1, 0.6, 1),
                                      chain_box(7, 1, 2, 1)},
      cornices{chain_box(-0.2, 7.4, 10.4, 0.4)};
  Dimensions d = find_dimensions(boxes, cornices, {{0, 0}, {10, 8}}, 0, kChainTolerance_m);
  d.columns.drop_narrowest();
  REQUIRE(d.columns.openings.size() == 2);
  CHECK(d.columns.openings[0].from == 1);
  CHECK(d.columns.openings[1].from == 7);
  d.columns.drop_narrowest();
  d.columns.drop_narrowest();
  CHECK(d.columns.sides().empty());
  // Ground, top, sill and head of the row, then the cornice's own edges.
  const std::vector<double> wanted{0, 8, 1, 2, 7.4, 7.8};
  REQUIRE(d.levels.size() == wanted.size());
  for (size_t i = 0; i < wanted.size(); ++i) CHECK(d.levels[i] == doctest::Approx(wanted[i]));
}
