// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Forms drawn into rasters with noise are found again.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "geometry/polygon2.h"
#include "modelling/evidence/shape_cells.h"
#include "modelling/evidence/shape_fit.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;

namespace {

// A wall of 120 x 100 cells with an opening of this form: one cell in a hundred of the wall without a point, one in
// three of the opening seen through.
WallCells drawn(const OpeningShape& shape, uint64_t seed) {
  RandomStream random(seed, 31);
  WallCells cells = painted::cells_of(120, 100);
  for (WallState& state : cells.states)
    if (random.uniform() < 0.01) state = WallState::kEmpty;
  for_cells(cells, shape, [&](uint32_t c, uint32_t r) {
    cells.states[size_t{r} * 120 + c] =
        random.uniform() < 0.35 ? WallState::kThrough : WallState::kEmpty;
  });
  return cells;
}

FittedShape found_in(const WallCells& cells, const OpeningShape& about) {
  const RingBox box = about.box();
  const auto line = [](double at) { return static_cast<uint32_t>(std::lround(at)); };
  return fitted_shape(cells, {},
                      {line(box.low.u), line(box.low.v), line(box.high.u), line(box.high.v)}, {});
}

// The largest difference of a size.
double worst_size(const OpeningShape& a, const OpeningShape& b) {
  double worst = 0;
  for (size_t i = 0; i < a.size_count(); ++i)
    worst = std::max(worst, std::fabs(a.sizes[i] - b.sizes[i]));
  return worst;
}

// Cells in one of them only, for each cell's length of the border: how far the borders lie apart on average.
double mean_distance(const WallCells& cells, const OpeningShape& a, const OpeningShape& b) {
  std::vector<int> count(cells.states.size(), 0);
  for (const OpeningShape* shape : {&a, &b})
    for_cells(cells, *shape,
              [&](uint32_t c, uint32_t r) { ++count[size_t{r} * cells.columns + c]; });
  return static_cast<double>(std::count(count.begin(), count.end(), 1)) /
         perimeter(flattened(b.ring(), 0.1));
}

}  // namespace

TEST_CASE("fitted_shape__recovers_the_form_with_borders_within_half_a_cell_on_average") {
  constexpr OpeningShape kForms[] = {{ShapeKind::kRectangle, {40, 64, 20, 60, 0, 0}},
                                     {ShapeKind::kArch, {40, 64, 20, 64, 12, 0}},  // a semicircle
                                     {ShapeKind::kArch, {40, 68, 20, 66, 24, 0}},  // pointed
                                     {ShapeKind::kCircle, {55, 45, 14, 0, 0, 0}},
                                     {ShapeKind::kTriangle, {35, 75, 25, 60, 55, 0}},
                                     {ShapeKind::kTriangle, {35, 75, 25, 60, 37, 0}},
                                     {ShapeKind::kGable, {40, 70, 20, 65, 20, 0}},
                                     {ShapeKind::kTrapezium, {35, 75, 25, 55, 45, 65}}};
  for (const OpeningShape& truth : kForms)
    for (uint64_t seed = 1; seed <= 10; ++seed) {
      CAPTURE(static_cast<int>(truth.kind));
      CAPTURE(seed);
      const WallCells cells = drawn(truth, seed);
      const FittedShape fitted = found_in(cells, truth);
      CHECK(fitted.shape.kind == truth.kind);
      CHECK(mean_distance(cells, fitted.shape, truth) <= 0.5);
    }
}

TEST_CASE("fitted_shape__fills_a_triangle_from_its_largest_box_however_fine_the_cells") {
  // Under a verge: upright on one side, sloping on the other.
  for (const uint32_t cells_across : {24u, 48u, 96u, 192u}) {
    const double side = cells_across;
    WallCells cells = painted::cells_of(2 * cells_across, 2 * cells_across);
    cells.cell_m = 2.4 / side;
    const double low = side / 2, high = low + side;
    const OpeningShape truth{ShapeKind::kTriangle, {low, high, low, high, high}};
    for_cells(cells, truth, [&](uint32_t c, uint32_t r) {
      cells.states[size_t{r} * cells.columns + c] = WallState::kThrough;
    });
    const OpeningShape box{ShapeKind::kRectangle, {low + side / 2, high, low, low + side / 2}};
    const FittedShape found = found_in(cells, box);
    CHECK(found.shape.kind == ShapeKind::kTriangle);
    CHECK(mean_distance(cells, found.shape, truth) < 1);
  }
}

TEST_CASE("fitted_shape__fills_a_flat_triangle_under_a_verge_of_few_cells") {
  // As cells of a scanned gable have it: a cell with a point of the wall is none of the opening.
  constexpr uint32_t kRows[] = {11, 9, 6, 4, 1}, kFoot = 40, kSide = 50;
  for (const bool is_left : {true, false}) {
    CAPTURE(is_left);
    WallCells cells = painted::cells_of(120, 100);
    // The verge: two cells of wall over the opening, the outside beyond them.
    for (uint32_t r = kFoot; r < 60; ++r)
      for (uint32_t c = 30; c < 80; ++c) {
        const double along = is_left ? c - double{kSide} : double{kSide} - c - 1;
        if (r - double{kFoot} > 7 - along / 1.9)
          cells.states[size_t{r} * 120 + c] = WallState::kOutside;
      }
    const auto paint = [&](uint32_t from, uint32_t to, uint32_t row) {
      painted::paint(cells, {from, row, to, row + 1}, WallState::kThrough);
    };
    for (uint32_t k = 0; k < std::size(kRows); ++k)
      is_left ? paint(kSide, kSide + kRows[k], kFoot + k)
              : paint(kSide - kRows[k], kSide, kFoot + k);
    const double low = is_left ? kSide : kSide - 12.0, high = low + 12;
    const FittedShape fitted = found_in(
        cells,
        painted::rectangle(is_left ? low : high - 9, is_left ? low + 9 : high, kFoot, kFoot + 2.0));
    CHECK(fitted.shape.kind == ShapeKind::kTriangle);
    const OpeningShape truth{ShapeKind::kTriangle,
                             {low, high, kFoot, kFoot + 5.5, is_left ? low : high}};
    CHECK(mean_distance(cells, fitted.shape, truth) < 1);
  }
}

TEST_CASE("fitted_shape__a_rectangle_stays_a_rectangle_in_two_hundred_rasters") {
  RandomStream random(9, 31);
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    const double left = 20 + 10 * random.uniform(), foot = 15 + 10 * random.uniform();
    const OpeningShape truth = painted::rectangle(left, left + 8 + 40 * random.uniform(), foot,
                                                  foot + 8 + 40 * random.uniform());
    const FittedShape fitted = found_in(drawn(truth, seed), truth);
    CAPTURE(seed);
    CHECK(fitted.shape.kind == ShapeKind::kRectangle);
    CHECK(worst_size(fitted.shape, truth) <= 1);
  }
}

TEST_CASE("fitted_shape__a_window_of_a_dozen_cells_is_no_circle") {
  RandomStream random(11, 31);
  size_t circles = 0;
  constexpr uint64_t kRasters = 200;
  for (uint64_t seed = 1; seed <= kRasters; ++seed) {
    const uint32_t width = 3 + static_cast<uint32_t>(random.below(2));
    const CellBox box{40, 20, 40 + width, 24};
    WallCells cells = painted::cells_of(120, 100);
    painted::paint(cells, box, WallState::kThrough);
    // Each corner has a point of the wall beside it as often as not.
    for (const uint32_t c : {box.c0, box.c1 - 1})
      for (const uint32_t r : {box.r0, box.r1 - 1})
        if (random.uniform() < 0.5) painted::paint(cells, {c, r, c + 1, r + 1}, WallState::kOn);
    circles += fitted_shape(cells, {}, box, {}).shape.kind == ShapeKind::kCircle;
  }
  CHECK(circles <= kRasters / 10);  // those with all four corners of the wall: one in sixteen
}

TEST_CASE("fitted_shape__does_not_tell_a_sloping_head_without_wall_beside_it") {
  const OpeningShape gable{ShapeKind::kGable, {40, 70, 20, 60, 15, 0}};
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    WallCells cells = drawn(gable, seed);
    CHECK(found_in(cells, gable).shape.kind == ShapeKind::kGable);
    // Beside its slopes now stand signs, which speak against an opening but are no wall.
    for (uint32_t r = 45; r < 62; ++r)
      for (uint32_t c = 34; c < 76; ++c) {
        WallState& state = cells.states[size_t{r} * 120 + c];
        if (state == WallState::kOn) state = WallState::kProud;
      }
    CHECK(found_in(cells, gable).shape.kind == ShapeKind::kRectangle);
  }
}

TEST_CASE("fitted_shape__the_score_is_the_weights_inside_less_what_the_sizes_cost") {
  WallCells cells = painted::cells_of(120, 100);
  painted::paint(cells, {40, 20, 60, 50}, WallState::kThrough);
  const OpeningShape truth = painted::rectangle(40, 60, 20, 50);
  const FittedShape fitted = found_in(cells, truth);
  CHECK(fitted.shape.sizes == truth.sizes);
  // Six cells and 60 percent of the sides about the box are looked at: 20 + 2 * 18 by 30 + 20 (to the wall's foot) +
  // 24.
  const double cost = 1.5 * std::log(56.0 * 74.0);
  CHECK(fitted.score == doctest::Approx(2 * 20 * 30 - 4 * cost).epsilon(1e-6));
}

TEST_CASE("fitted_shape__does_not_cross_a_post_into_the_next_bay") {
  // Bays of 5.5 m between posts of 0.4 m, as points 0.1 m apart show them; seen through all over.
  WallCells cells = painted::cells_of(90, 40, WallState::kOn, 0.22);
  for (const uint32_t left : {2U, 29U, 56U})
    painted::paint(cells, {left, 10, left + 25, 27}, WallState::kThrough);
  const FittedShape middle = fitted_shape(cells, {}, {29, 10, 54, 27}, {});
  CHECK(middle.shape.kind == ShapeKind::kRectangle);
  CHECK(worst_size(middle.shape, painted::rectangle(29, 54, 10, 27)) <= 0.5);
}

TEST_CASE("fitted_shape__keeps_both_sides_of_a_mullion_in_the_walls_plane") {
  WallCells cells = painted::cells_of(60, 60, WallState::kOn, 0.05);
  painted::paint(cells, {10, 10, 40, 40}, WallState::kThrough);
  painted::paint(cells, {20, 10, 22, 40}, WallState::kOn);
  const FittedShape whole = fitted_shape(cells, {}, {10, 10, 40, 40}, {});
  CHECK(worst_size(whole.shape, painted::rectangle(10, 40, 10, 40)) <= 0.5);
}

TEST_CASE("fitted_shape__keeps_out_of_cells_of_other_openings") {
  WallCells cells = painted::cells_of(120, 100);
  painted::paint(cells, {40, 20, 80, 50}, WallState::kThrough);
  std::vector<uint8_t> taken(cells.states.size(), 0);
  painted::paint(taken, 120, {60, 20, 80, 50}, uint8_t{1});
  const FittedShape fitted = fitted_shape(cells, taken, {40, 20, 62, 50}, {});
  CHECK(fitted.shape.sizes == painted::rectangle(40, 60, 20, 50).sizes);
}
