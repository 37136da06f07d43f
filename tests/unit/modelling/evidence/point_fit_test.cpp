// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Shapes of openings fitted to the points that border them, where cells are too coarse.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "modelling/evidence/point_fit.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;

namespace {

constexpr double kSpacing_m = 0.06;

// Points at random on a wall of 6 x 6 m, one for each square of a spacing, but for those in the opening.
std::vector<Vec2> points_about(const OpeningShape& opening, uint64_t seed) {
  RandomStream random(seed, 3);
  std::vector<Vec2> out;
  for (int k = 0; k < 100 * 100; ++k) {
    const Vec2 p{6 * random.uniform(), 6 * random.uniform()};
    if (!opening.holds(p)) out.push_back(p);
  }
  return out;
}

// Cells of 2.2 spacings that have points or are seen through.
WallCells cells_with(const std::vector<Vec2>& points) {
  const double cell_m = 2.2 * kSpacing_m;
  const auto lines = static_cast<uint32_t>(std::ceil(6 / cell_m));
  WallCells out = painted::cells_of(lines, lines, WallState::kThrough, cell_m);
  for (const Vec2& p : points)
    out.states[static_cast<size_t>(p.v / cell_m) * lines + static_cast<size_t>(p.u / cell_m)] =
        WallState::kOn;
  return out;
}

OpeningShape fitted(const OpeningShape& opening, const RingBox& start, uint64_t seed) {
  const std::vector<Vec2> points = points_about(opening, seed);
  const OpeningShape box = painted::rectangle(start.low.u, start.high.u, start.low.v, start.high.v);
  return fitted_to_points(box, cells_with(points), points);
}

}  // namespace

TEST_CASE("fitted_to_points__tells_flat_arches_from_rectangles_to_a_fraction_of_a_spacing") {
  // Two cells of rise: the box that cells tell ends below the arch.
  const OpeningShape arch{ShapeKind::kArch, {2, 3, 1, 2.7, 0.28, 0}};
  const OpeningShape square = painted::rectangle(2, 3, 1, 2.7);
  size_t arches = 0, false_arches = 0;
  double squares = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    const OpeningShape a = fitted(arch, {{2.1, 1.1}, {2.9, 2.45}}, seed);
    arches += a.kind == ShapeKind::kArch && std::fabs(a.sizes[3] - 2.7) < kSpacing_m / 2;
    const OpeningShape b = fitted(square, {{2.1, 1.1}, {2.9, 2.6}}, seed);
    false_arches += b.kind != ShapeKind::kRectangle;
    for (size_t k = 0; k < 4; ++k) {
      const double off = (b.sizes[k] - square.sizes[k]) / kSpacing_m;
      squares += off * off / 4 / 40;
    }
  }
  MESSAGE("FIGURE flat arches at " << kSpacing_m << " m: " << arches << " of 40");
  CHECK(arches >= 32);
  CHECK(false_arches == 0);
  CHECK(std::sqrt(squares) < 0.25);
}

TEST_CASE("fitted_to_points__stray_points_in_an_opening_do_not_part_it") {
  const OpeningShape opening = painted::rectangle(2, 3, 1, 2.7);
  std::vector<Vec2> points = points_about(opening, 5);
  const WallCells cells = cells_with(points);
  for (const Vec2& stray : {Vec2{2.3, 1.4}, {2.7, 2.2}, {2.5, 1.9}}) points.push_back(stray);
  const OpeningShape found =
      fitted_to_points(painted::rectangle(2.1, 2.9, 1.1, 2.6), cells, points);
  CHECK(overlap(found.box(), opening.box()) > 0.93);
}

TEST_CASE("fitted_to_points__a_strip_of_the_wall_below_a_window_ends_where_its_points_do") {
  // Between the window and the panel below it: too narrow for a pier, and the window's foot crosses its cells.
  const OpeningShape opening = painted::rectangle(2, 3, 1, 2.7);
  double worst = 0;
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<Vec2> points = points_about(opening, seed);
    WallCells cells = cells_with(points);
    const auto row = static_cast<uint32_t>(1 / cells.cell_m);
    for (uint32_t c = 0; c < cells.columns; ++c) {
      WallState& state = cells.states[size_t{row} * cells.columns + c];
      if (state == WallState::kOn) state = WallState::kStrip;
    }
    const OpeningShape found =
        fitted_to_points(painted::rectangle(2.1, 2.9, 1.1, 2.6), cells, points);
    worst = std::max(worst, std::fabs(found.box().low.v - 1));
  }
  CHECK(worst < kSpacing_m / 2);
}
