// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/cell_decomposition.h"

#include <doctest/doctest.h>

#include "base/random.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;

namespace {

// A wall of 12 x 6 m in cells of 5 cm.
struct DecomposedWall {
  WallCells cells = painted::cells_of(240, 120);
  OpeningSearch setting{.by_cells = true};

  DecomposedWall& with(double left, double foot, double width, double height,
                       WallState state = WallState::kThrough) {
    const auto line = [](double at) { return static_cast<uint32_t>(std::lround(at * 20)); };
    painted::paint(cells, {line(left), line(foot), line(left + width), line(foot + height)}, state);
    return *this;
  }
  std::vector<OpeningCandidate> openings() const {
    Task task;
    std::vector<OpeningCandidate> out = decomposed_openings(cells, setting, task);
    std::erase_if(out, [](const OpeningCandidate& c) { return !c.is_opening; });
    return out;
  }
};

void check_decomposed(const OpeningCandidate& found, double left, double foot, double width,
                      double height, double within_m = 1e-9) {
  const RingBox box = found.shape.box();
  CHECK(std::fabs(box.low.u - left) < within_m);
  CHECK(std::fabs(box.low.v - foot) < within_m);
  CHECK(std::fabs(box.width() - width) < within_m);
  CHECK(std::fabs(box.height() - height) < within_m);
}

}  // namespace

TEST_CASE("cell_decomposition__windows_in_rows_and_a_door__are_found_where_they_are") {
  DecomposedWall wall;
  for (const double left : {1.0, 4.0, 9.0}) wall.with(left, 3, 1.2, 1.5);
  wall.with(6.5, 0, 1, 2.1);  // to the wall's foot
  const auto found = wall.openings();
  REQUIRE(found.size() == 4);
  check_decomposed(found[0], 1, 3, 1.2, 1.5);
  check_decomposed(found[1], 4, 3, 1.2, 1.5);
  check_decomposed(found[2], 6.5, 0, 1, 2.1);
  check_decomposed(found[3], 9, 3, 1.2, 1.5);
}

TEST_CASE("cell_decomposition__gaps_between_points__make_neither_lines_nor_openings") {
  DecomposedWall wall;
  RandomStream random(5, 0);
  for (WallState& state : wall.cells.states)
    if (random.uniform() < 0.03) state = WallState::kEmpty;
  CHECK(wall.openings().empty());
  wall.with(5, 2, 1.4, 1.6);
  const auto found = wall.openings();
  REQUIRE(found.size() == 1);
  check_decomposed(found[0], 5, 2, 1.4, 1.6, 0.025);  // half a cell
}

TEST_CASE("cell_decomposition__an_l_shaped_opening__is_two_blocks_that_do_not_overlap") {
  DecomposedWall wall;
  wall.with(3, 1, 3, 1).with(3, 2, 1, 2);
  const auto found = wall.openings();
  REQUIRE(found.size() == 2);
  double area = 0;
  for (const OpeningCandidate& c : found) area += c.shape.box().width() * c.shape.box().height();
  CHECK(area == doctest::Approx(5));
}

TEST_CASE("cell_decomposition__its_parameters__decide_what_is_a_line_and_what_is_a_wall") {
  DecomposedWall wall;
  wall.with(2, 2, 0.4, 0.4).with(6, 2, 2, 2);
  CHECK(wall.openings().size() == 1);  // a hatch of 0.4 m has no line of its own
  wall.setting.edge_length_m = 0.3;
  CHECK(wall.openings().size() == 2);
  wall.setting.least_width_m = 0.5;
  CHECK(wall.openings().size() == 1);
  wall.with(6, 2, 2, 1.2, WallState::kOn);  // no border at its foot: what is below is wall
  CHECK(wall.openings().size() == 1);
  wall.setting.wall_share = 0;
  CHECK(wall.openings().empty());
}

TEST_CASE("cell_decomposition__a_wall_without_cells_or_openings__has_none") {
  Task task;
  CHECK(decomposed_openings({}, {}, task).empty());
  CHECK(DecomposedWall().openings().empty());
}
