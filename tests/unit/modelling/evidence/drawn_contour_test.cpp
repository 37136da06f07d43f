// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The contour of a wall whose openings are known.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "geometry/polygon2.h"
#include "modelling/evidence/drawn_contour.h"
#include "modelling/plane/ring_tools.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;

namespace {

constexpr double kApart_m = 0.03;
using painted::rectangle;
const OpeningShape kWindow = rectangle(2, 3.2, 1.5, 3), kDoor = rectangle(5, 6, 0, 2.2);

bool is_within(const OpeningShape& shape, const Vec2& p) { return shape.box().holds(p); }

// A wall of 8 x 5 m; its window has leaves of strips flush with the wall.
std::vector<Vec2> wall_points(const OpeningShape& missing) {
  RandomStream random(2, 50);
  std::vector<Vec2> out;
  for (double u = kApart_m / 2; u < 8; u += kApart_m)
    for (double v = kApart_m / 2; v < 5; v += kApart_m) {
      const Vec2 p{u + 0.4 * kApart_m * (random.uniform() - 0.5),
                   v + 0.4 * kApart_m * (random.uniform() - 0.5)};
      const bool is_strip = std::fabs(p.u - 2.6) < 0.08 || std::fabs(p.v - 2.2) < 0.08;
      if (is_within(kDoor, p) || is_within(missing, p) || (is_within(kWindow, p) && !is_strip))
        continue;
      out.push_back(p);
    }
  return out;
}

Contour drawn_with(const OpeningShape& missing, WallState state_there) {
  WallCells cells = painted::cells_of(122, 76, WallState::kOn, 2.2 * kApart_m);
  for (uint32_t r = 0; r < cells.rows; ++r)
    for (uint32_t c = 0; c < cells.columns; ++c)
      if (is_within(missing, Vec2{c + 0.5, r + 0.5} * cells.cell_m))
        cells.states[size_t{r} * cells.columns + c] = state_there;
  std::vector<OpeningCandidate> candidates(2);
  candidates[0].shape = kWindow, candidates[1].shape = kDoor;
  for (OpeningCandidate& c : candidates) c.is_opening = true;
  Task task;
  const std::vector<Vec2> points = wall_points(missing);
  return drawn_contour(points, candidates, extract_contour(points, {}, task), cells, {}, {}, task);
}

const OpeningShape kPatch = rectangle(6.6, 7.4, 3, 4);

}  // namespace

TEST_CASE("drawn_contour__has_the_window_whole_and_the_door_cut_out_of_the_outline") {
  const Contour contour = drawn_with(rectangle(-2, -1, 0, 1), WallState::kOn);
  REQUIRE(contour.pieces.size() == 1);
  const ContourPiece& piece = contour.pieces[0];
  REQUIRE(piece.openings.size() == 1);  // flush strips do not part it
  RingBox box;
  box.add(piece.openings[0]);
  const RingBox truth = kWindow.box();
  CHECK(norm(box.low - truth.low) < 3 * kApart_m);
  CHECK(norm(box.high - truth.high) < 3 * kApart_m);
  CHECK(signed_area(piece.openings[0]) < 0);
  CHECK(signed_area(piece.outline) == doctest::Approx(8 * 5 - 2.2).epsilon(0.02).scale(0));
  CHECK_FALSE(contains(piece.outline, {5.5, 1}));
  CHECK_FALSE(contains(piece.outline, {5.5, 0.02}));
  CHECK(contains(piece.outline, {5.5, 2.6}));
}

TEST_CASE("drawn_contour__keeps_a_hole_where_nothing_was_measured_and_goes_on_over_relief") {
  const Contour unseen = drawn_with(kPatch, WallState::kHidden);
  REQUIRE(unseen.pieces.size() == 1);
  REQUIRE(unseen.pieces[0].openings.size() == 2);
  RingBox box;
  box.add(unseen.pieces[0].openings[1]);
  CHECK(norm(box.middle() - kPatch.box().middle()) < kApart_m);
  CHECK(box.width() == doctest::Approx(0.8).epsilon(0.1).scale(0));
  const Contour relief = drawn_with(kPatch, WallState::kRelief);
  REQUIRE(relief.pieces.size() == 1);
  CHECK(relief.pieces[0].openings.size() == 1);
}

TEST_CASE("drawn_contour__has_no_lintel_between_a_door_and_what_a_canopy_hides_above_it") {
  const Contour hidden = drawn_with(rectangle(4.8, 6.2, 2.2, 3), WallState::kHidden);
  REQUIRE(hidden.pieces.size() == 1);
  const ContourPiece& piece = hidden.pieces[0];
  CHECK(piece.openings.size() == 1);
  CHECK_FALSE(contains(piece.outline, {5.5, 2.25}));
  CHECK_FALSE(contains(piece.outline, {5.5, 2.8}));
  CHECK(contains(piece.outline, {5.5, 3.1}));
  CHECK(contains(piece.outline, {4.9, 2.1}));
  CHECK(contains(piece.outline, {6.1, 2.1}));
  // A window inside the wall stays apart from what was not measured above it.
  const Contour above = drawn_with(rectangle(2, 3.2, 3, 3.6), WallState::kHidden);
  REQUIRE(above.pieces.size() == 1);
  CHECK(above.pieces[0].openings.size() == 2);
}

TEST_CASE("drawn_contour__what_was_not_measured_never_lies_over_an_opening_that_a_hole_shows") {
  // Beside a plain window the wall goes on as a hole that was seen through: the window is drawn by the whole hole, and
  // what its own shape leaves of that is no second one.
  const OpeningShape window = rectangle(2, 4, 1, 3), dent = rectangle(4, 4.7, 1, 2.2);
  std::vector<Vec2> points;
  for (double u = kApart_m / 2; u < 8; u += kApart_m)
    for (double v = kApart_m / 2; v < 5; v += kApart_m)
      if (!is_within(window, {u, v}) && !is_within(dent, {u, v})) points.push_back({u, v});
  WallCells cells = painted::cells_of(122, 76, WallState::kOn, 2.2 * kApart_m);
  for (uint32_t r = 0; r < cells.rows; ++r)
    for (uint32_t c = 0; c < cells.columns; ++c)
      if (const Vec2 p = Vec2{c + 0.5, r + 0.5} * cells.cell_m;
          is_within(window, p) || is_within(dent, p))
        cells.states[size_t{r} * cells.columns + c] = WallState::kThrough;
  std::vector<OpeningCandidate> candidates(1);
  candidates[0].shape = window;
  candidates[0].is_opening = true;
  Task task;
  const Contour contour =
      drawn_contour(points, candidates, extract_contour(points, {}, task), cells, {}, {}, task);
  REQUIRE(contour.pieces.size() == 1);
  REQUIRE(contour.pieces[0].openings.size() == 1);
  CHECK(-signed_area(contour.pieces[0].openings[0]) ==
        doctest::Approx(2 * 2 + 0.7 * 1.2).epsilon(0.05).scale(0));
}

TEST_CASE("drawn_contour__an_opening_in_the_way_out_of_a_broad_one_is_at_the_border_too") {
  // A band stands on a pier, with a broad opening between them that is open below beside the pier; a slot ends below
  // it.
  const OpeningShape broad = rectangle(0.5, 7.5, 2, 4), slot = rectangle(6, 6.3, 0.8, 1.86);
  std::vector<Vec2> points;
  for (double u = kApart_m / 2; u < 8; u += kApart_m)
    for (double v = kApart_m / 2; v < 5; v += kApart_m)
      if ((v > 4 || u > 5.4) && !is_within(broad, {u, v}) && !is_within(slot, {u, v}) &&
          (v > 4 || u < 7))
        points.push_back({u, v});
  WallCells cells = painted::cells_of(122, 76, WallState::kOn, 2.2 * kApart_m);
  for (uint32_t r = 0; r < cells.rows; ++r)
    for (uint32_t c = 0; c < cells.columns; ++c)
      if (const Vec2 p = Vec2{c + 0.5, r + 0.5} * cells.cell_m;
          is_within(broad, p) || is_within(slot, p))
        cells.states[size_t{r} * cells.columns + c] = WallState::kThrough;
  std::vector<OpeningCandidate> candidates(2);
  candidates[0].shape = broad, candidates[1].shape = slot;
  for (OpeningCandidate& c : candidates) c.is_opening = true;
  Task task;
  const Contour contour =
      drawn_contour(points, candidates, extract_contour(points, {}, task), cells, {}, {}, task);
  CHECK(contour.pieces.size() == 2);
  const auto is_wall = [&](const Vec2& p) {
    return std::any_of(
        contour.pieces.begin(), contour.pieces.end(), [&](const ContourPiece& piece) {
          return contains(piece.outline, p) &&
                 std::none_of(piece.openings.begin(), piece.openings.end(),
                              [&](const Chain& opening) { return contains(opening, p); });
        });
  };
  for (const ContourPiece& piece : contour.pieces)
    for (const Chain& opening : piece.openings)
      for (const Vec2& p : opening) CHECK(contains(piece.outline, p));
  CHECK(is_wall({5.7, 1}));
  CHECK(is_wall({6.65, 1}));
  CHECK(is_wall({6.15, 0.5}));
  CHECK(is_wall({4, 4.5}));
  for (const double v : {1.0, 1.8, 1.95, 3.0}) CHECK_FALSE(is_wall({6.15, v}));
}
