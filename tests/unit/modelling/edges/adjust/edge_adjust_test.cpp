// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Edges moved to where the points say.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/edges/adjust/edge_adjust.h"
#include "unit/modelling/edge_points.h"

using namespace edge_points;

namespace {

constexpr EdgeSetting kEdges{kSpacing_m, 0.001, 0.004, true, 0.05};

CountingVariance of_random_points() { return counting_variance({}, kSpacing_m, 0.001); }

}  // namespace

TEST_CASE("edge_adjust__without_evidence_an_edge_stays_with_the_sigma_of_contours") {
  MeasuredEdge edge = edge_along({0.6, 0.8}, 5);
  const EdgeLine before = edge.shape.line;
  const EdgeInformation information = adjust_edge(kEdges, of_random_points(), edge);
  CHECK(edge.shape.line.point == before.point);
  CHECK(edge.shape.line.direction == before.direction);
  CHECK(edge.moved_m == 0);
  CHECK(edge.shape.source == EdgeSource::kContour);
  CHECK(edge.shape.sigma_m > 0.1 * kSpacing_m);
  CHECK(edge.shape.sigma_m < kSpacing_m);
  CHECK(information[0] == doctest::Approx(1 / std::pow(edge.shape.sigma_m, 2)));
}

TEST_CASE("edge_adjust__goes_where_the_density_begins_within_its_sigma_and_keeps_its_direction") {
  double scaled = 0, trials = 0;
  for (uint64_t k = 0; k < 100; ++k) {
    RandomStream random(k, 51);
    const double truth_m = kSpacing_m * (random.uniform() - 0.5);
    MeasuredEdge edge = edge_along({0, 1}, 8);
    add_random_blocks(edge, 8, random, [&](double) { return truth_m; });
    adjust_edge(kEdges, of_random_points(), edge);
    CHECK(edge.shape.line.direction == Vec2{0, 1});
    CHECK(edge.shape.source == EdgeSource::kDensity);
    const double at_m = -edge.shape.line.point.u;  // into the solid: to the left, towards -u
    CHECK(edge.moved_m == doctest::Approx(at_m));
    scaled += std::pow((at_m - truth_m) / edge.shape.sigma_m, 2);
    trials += 1;
  }
  CHECK(std::sqrt(scaled / trials) > 0.7);
  CHECK(std::sqrt(scaled / trials) < 1.3);
}

TEST_CASE("edge_adjust__turns_a_slanted_edge_to_its_points_and_an_upright_one_not") {
  const double slope = 0.01;
  RandomStream random(4, 52);
  MeasuredEdge slanted = edge_along({0.8, 0.6}, 12), level = edge_along({1, 0}, 12);
  const double middle_m = slanted.shape.length_m / 2;
  for (MeasuredEdge* edge : {&slanted, &level})
    add_random_blocks(*edge, 12, random, [&](double t) { return slope * (t - middle_m); });
  adjust_edge(kEdges, of_random_points(), slanted);
  adjust_edge(kEdges, of_random_points(), level);
  const Vec2 d = slanted.shape.line.direction;
  CHECK(cross(Vec2{0.8, 0.6}, d) == doctest::Approx(slope).epsilon(0.35).scale(0));
  CHECK(norm(d) == doctest::Approx(1));
  CHECK(level.shape.line.direction == Vec2{1, 0});
}

TEST_CASE("edge_adjust__a_reveal_of_many_points_wins_over_the_density") {
  RandomStream random(6, 53);
  MeasuredEdge edge = edge_along({1, 0}, 12);
  add_random_blocks(edge, 12, random, [](double) { return 0.0; });
  for (double h = 0.005; h < 0.2; h += 0.01)
    for (double t = 0; t < edge.shape.length_m; t += 0.02)
      edge.behind.push_back({t, 0.004 + 0.001 * random.normal(), -h});
  MeasuredEdge without = edge;
  adjust_edge(kEdges, of_random_points(), edge);
  CHECK(edge.shape.source == EdgeSource::kReveal);
  CHECK(edge.moved_m == doctest::Approx(0.004).epsilon(0.1).scale(0));
  EdgeSetting setting = kEdges;
  setting.reveals = false;
  adjust_edge(setting, of_random_points(), without);
  CHECK(without.shape.source == EdgeSource::kDensity);
  CHECK(std::fabs(without.moved_m) < 0.002);
  CHECK(edge.shape.sigma_m < without.shape.sigma_m);
}

TEST_CASE("edge_adjust__a_given_edge_goes_to_its_reveal_alone_and_stays_without_one") {
  RandomStream random(8, 57);
  MeasuredEdge edge = edge_along({1, 0}, 12);
  add_random_blocks(edge, 12, random, [](double) { return -0.01; });
  const EdgeLine before = edge.shape.line;
  move_to_reveal(kEdges, edge);
  CHECK(edge.shape.line.point == before.point);
  CHECK(edge.moved_m == 0);
  // The face of a surround before the wall is no reveal, however many points it has.
  for (double h = 0.005; h < 0.2; h += 0.01)
    for (double t = 0; t < edge.shape.length_m; t += 0.02) {
      edge.before.push_back({t, 0.015, h});
      edge.behind.push_back({t, 0.004 + 0.001 * random.normal(), -h});
    }
  move_to_reveal(kEdges, edge);
  CHECK(edge.shape.source == EdgeSource::kReveal);
  CHECK(edge.moved_m == doctest::Approx(0.004).epsilon(0.1).scale(0));
  CHECK(edge.shape.line.point.v - before.point.v == doctest::Approx(edge.moved_m));
  CHECK(edge.shape.sigma_m < 0.002);
}
