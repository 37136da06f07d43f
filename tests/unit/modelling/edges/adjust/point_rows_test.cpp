// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Rows of points along edges.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/edges/adjust/point_rows.h"
#include "unit/modelling/edge_points.h"

using namespace edge_points;

namespace {

/// Blocks of rows at this distance, each block with a phase of its own, points off their row by noise.
MeasuredEdge with_rows(double distance_m, double noise_m, size_t blocks) {
  MeasuredEdge out = edge_along({1, 0}, blocks);
  RandomStream random(blocks, 41);
  add_blocks(out, blocks, [&](EdgeBlock& block) {
    const double phase_m = distance_m * random.uniform();
    for (double d = phase_m - 0.02; d < kStripInward * kSpacing_m; d += distance_m)
      for (int column = 0; column < 8; ++column)
        block.points.push_back({d + noise_m * random.normal(), 1});
  });
  return out;
}

Rows rows_of(const MeasuredEdge& edge) {
  const MeasuredEdge* edges[] = {&edge};
  return find_rows(edges, kSpacing_m);
}

}  // namespace

TEST_CASE("point_rows__their_distance_is_found_and_noise_makes_them_less_plain") {
  for (const double distance_m : {0.007, 0.01, 0.014}) {
    CAPTURE(distance_m);
    const Rows plain = rows_of(with_rows(distance_m, 0, 16));
    CHECK(plain.distance_m == doctest::Approx(distance_m).epsilon(0.05).scale(0));
    CHECK(plain.visibility > 0.9);
    CHECK(plain.visibility <= 1.0001);
    const Rows noisy = rows_of(with_rows(distance_m, 0.15 * distance_m, 16));
    CHECK(noisy.distance_m == doctest::Approx(distance_m).epsilon(0.05).scale(0));
    // The first harmonic of a blurred row: exp(-2 pi^2 s^2 / q^2).
    CHECK(noisy.visibility == doctest::Approx(0.64).epsilon(0.1).scale(0));
  }
}

TEST_CASE("point_rows__points_at_random_have_none") {
  MeasuredEdge edge = edge_along({1, 0}, 40);
  RandomStream random(9, 42);
  add_random_blocks(edge, 40, random, [](double) { return -1.0; });
  const Rows rows = rows_of(edge);
  CHECK(rows.distance_m == 0);
  CHECK(rows.visibility == 0);
}

TEST_CASE("point_rows__blocks_of_thin_solid_tell_nothing") {
  MeasuredEdge edge = with_rows(0.01, 0, 10);
  for (EdgeBlock& block : edge.blocks) block.depth_m *= 0.9;
  CHECK(rows_of(edge).visibility == 0);
  CHECK(find_rows({}, kSpacing_m).visibility == 0);
}
