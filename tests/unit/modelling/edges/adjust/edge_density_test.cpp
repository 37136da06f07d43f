// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Where the density of points begins, and what counting is worth.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/edges/adjust/edge_density.h"
#include "unit/modelling/edge_points.h"

using namespace edge_points;

namespace {

CountingVariance edge_density_of_random_points() {
  return counting_variance({}, kSpacing_m, 0.001);
}

}  // namespace

TEST_CASE("edge_density__of_random_points_is_unbiased_and_worth_what_its_weight_says") {
  const CountingVariance variance = edge_density_of_random_points();
  CHECK(variance.common_m2 == 0);
  CHECK(variance.of(2) == doctest::Approx(variance.along_m3 / 2));
  double n = 0, sum = 0, scaled = 0;
  for (uint64_t k = 0; k < 300; ++k) {
    RandomStream random(k, 31);
    const double truth_m = kSpacing_m * (random.uniform() - 0.5);
    MeasuredEdge edge = edge_along({1, 0}, 4);
    add_random_blocks(edge, 4, random, [&](double) { return truth_m; });
    const auto offsets = density_offsets(edge, kSpacing_m, 0, variance);
    REQUIRE(offsets.size() == 4);
    for (size_t b = 0; b < 4; ++b) {
      CHECK(offsets[b].t_m == edge.blocks[b].t_m);
      const double error_m = offsets[b].offset_m - truth_m;
      n += 1;
      sum += error_m;
      scaled += error_m * error_m * offsets[b].weight;
    }
  }
  CHECK(std::fabs(sum / n) < 0.05 * kSpacing_m);
  CHECK(std::sqrt(scaled / n) > 0.7);
  CHECK(std::sqrt(scaled / n) < 1.3);
}

TEST_CASE("edge_density__points_told_to_be_no_solid_do_not_move_the_edge") {
  const CountingVariance variance = edge_density_of_random_points();
  RandomStream random(7, 32);
  MeasuredEdge edge = edge_along({1, 0}, 6);
  add_random_blocks(edge, 6, random, [](double) { return 0.0; });
  const auto clean = density_offsets(edge, kSpacing_m, 0, variance);
  for (EdgeBlock& block : edge.blocks)  // a reveal's first row, right at the edge
    for (int i = 0; i < 4; ++i) block.points.insert(block.points.begin(), {-0.001, 1});
  const auto drawn = density_offsets(edge, kSpacing_m, 0, variance);
  const auto told = density_offsets(edge, kSpacing_m, 4 / kBlock_m, variance);
  REQUIRE(told.size() == clean.size());
  for (size_t b = 0; b < clean.size(); ++b) {
    CHECK(drawn[b].offset_m < clean[b].offset_m - 0.2 * kSpacing_m);
    CHECK(told[b].offset_m == doctest::Approx(clean[b].offset_m));
  }
}

TEST_CASE("edge_density__needs_points_and_some_depth_of_solid") {
  const CountingVariance variance = edge_density_of_random_points();
  RandomStream random(8, 33);
  MeasuredEdge edge = edge_along({1, 0}, 3);
  add_random_blocks(edge, 3, random, [](double) { return 0.0; });
  edge.blocks[0].depth_m = kSpacing_m;
  edge.blocks[1].points.clear();
  const auto offsets = density_offsets(edge, kSpacing_m, 0, variance);
  REQUIRE(offsets.size() == 1);
  CHECK(offsets[0].t_m == edge.blocks[2].t_m);
  CHECK(density_offsets({}, kSpacing_m, 0, variance).empty());
}

TEST_CASE("edge_density__counting_is_worth_more_on_a_grid_than_at_random") {
  const double poisson = edge_density_of_random_points().along_m3;
  std::vector<MeasuredEdge> edges(20, edge_along({1, 0}, 5)), grid = edges;
  for (size_t k = 0; k < edges.size(); ++k) {
    RandomStream random(k, 34);
    add_random_blocks(edges[k], 5, random, [](double) { return -1.0; });
    const double phase_m = kSpacing_m * random.uniform();
    add_blocks(grid[k], 5, [&](EdgeBlock& block) {
      for (double d = phase_m - 0.03; d < kStripInward * kSpacing_m; d += kSpacing_m)
        for (int column = 0; column < 8; ++column) block.points.push_back({d, 1});
    });
  }
  std::vector<const MeasuredEdge*> at_random, on_grid;
  for (const MeasuredEdge& e : edges) at_random.push_back(&e);
  for (const MeasuredEdge& e : grid) on_grid.push_back(&e);
  const CountingVariance r = counting_variance(at_random, kSpacing_m, 0.001);
  CHECK(r.along_m3 == doctest::Approx(poisson).epsilon(0.35).scale(0));
  const CountingVariance g = counting_variance(on_grid, kSpacing_m, 0.001);
  CHECK(g.along_m3 < 0.1 * poisson);
  CHECK(g.common_m2 <= kSpacing_m * kSpacing_m / 12 * 1.05);
}
