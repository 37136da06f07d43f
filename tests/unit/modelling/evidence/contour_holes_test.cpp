// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Which hole of a contour is an opening's, on rings made by hand.
#include <doctest/doctest.h>

#include "geometry/polygon2.h"
#include "modelling/evidence/contour_holes.h"
#include "unit/modelling/painted_cells.h"

using namespace jalon;

namespace {

constexpr double kSpacing_m = 0.05;
using painted::rectangle;

Chain box_chain(double left, double foot, double right, double head) {
  return {{left, foot}, {right, foot}, {right, head}, {left, head}};
}
Chain hole_chain(double left, double foot, double right, double head) {
  const Chain chain = box_chain(left, foot, right, head);
  return {chain.rbegin(), chain.rend()};
}

// A wall of 6 x 4 m with these holes.
Contour wall_with(std::vector<Chain> holes) {
  Contour out;
  out.spacing_m = kSpacing_m;
  out.pieces.push_back({box_chain(0, 0, 6, 4), std::move(holes), 24});
  return out;
}

WallCells bare_wall() { return painted::cells_of(60, 40, WallState::kOn, 0.1); }

const OpeningShape kLeftWindow = rectangle(1, 2, 1, 2.5), kRightWindow = rectangle(4, 5, 1, 2.5);

}  // namespace

TEST_CASE("cut_out__joins_an_opening_beside_the_border_to_it_and_keeps_one_inside") {
  const Chain outline = box_chain(0, 0, 6, 4);
  const auto cut = [&](double left) {
    const PolygonWithHoles opening{box_chain(left, 1, 2, 3), {}};
    return cut_out({outline, {}}, {{opening}}, 0.02);
  };
  const auto beside = cut(0.01);
  REQUIRE(beside.size() == 1);
  CHECK(beside[0].holes.empty());
  CHECK(signed_area(beside[0].outline) == doctest::Approx(24 - 2 * 1.99).epsilon(0.001));
  CHECK_FALSE(contains(beside[0].outline, {1, 2}));
  const auto inside = cut(0.5);
  REQUIRE(inside.size() == 1);
  CHECK(inside[0].holes.size() == 1);
}

TEST_CASE("holes_of__each_opening_gets_the_hole_at_its_place_whatever_their_order") {
  const Chain first = hole_chain(1.01, 0.99, 2.02, 2.5), second = hole_chain(4, 1.02, 4.99, 2.51);
  for (const bool turned : {false, true}) {
    const Contour contour = turned ? wall_with({second, first}) : wall_with({first, second});
    const auto found = holes_of(contour, std::vector{kLeftWindow, kRightWindow}, bare_wall());
    REQUIRE(found.size() == 2);
    CHECK(found[0] == first);
    CHECK(found[1] == second);
  }
}

TEST_CASE("holes_of__a_hole_that_goes_on_where_nothing_was_seen_is_none") {
  // A third more of the opening: hidden by a tree, or seen through.
  const Contour contour = wall_with({hole_chain(1, 1, 2.5, 2.5)});
  WallCells hidden = bare_wall(), seen = bare_wall();
  painted::paint(hidden, {20, 10, 25, 25}, WallState::kHidden);
  painted::paint(seen, {20, 10, 25, 25}, WallState::kThrough);
  CHECK(holes_of(contour, std::vector{kLeftWindow}, hidden)[0].empty());
  CHECK(holes_of(contour, std::vector{kLeftWindow}, seen)[0] == contour.pieces[0].openings[0]);
}

TEST_CASE("holes_of__an_opening_elsewhere_has_none") {
  CHECK(holes_of(wall_with({hole_chain(1, 1, 2, 2.5)}), std::vector{kRightWindow}, bare_wall())[0]
            .empty());
  CHECK(holes_of(wall_with({}), std::vector{kRightWindow}, bare_wall())[0].empty());
}

TEST_CASE("shows__the_same_openings_and_no_other") {
  const Chain first = hole_chain(1, 1, 2, 2.5), second = hole_chain(4, 1, 5, 2.5);
  const std::vector both{kLeftWindow, kRightWindow};
  CHECK(shows(wall_with({first, second}), both));
  CHECK_FALSE(shows(wall_with({first}), both));
  CHECK_FALSE(shows(wall_with({first, second}), std::vector{kLeftWindow}));
  CHECK(shows(wall_with({}), {}));
}

TEST_CASE("shows__an_opening_that_the_outline_goes_round_too") {
  Contour contour = wall_with({hole_chain(1, 1, 2, 2.5)});
  // A doorway from 4 to 5 m, open to the ground.
  contour.pieces[0].outline = {{0, 0}, {4, 0}, {4, 2.2}, {5, 2.2}, {5, 0}, {6, 0}, {6, 4}, {0, 4}};
  CHECK(shows(contour, std::vector{kLeftWindow, rectangle(4, 5, 0, 2.2)}));
  CHECK_FALSE(shows(contour, std::vector{kLeftWindow, rectangle(3, 4.2, 0, 2.2)}));
}

TEST_CASE("contour_holes__a_place_at_the_border_is_cut_out_and_takes_the_opening_that_it_touches") {
  constexpr double kStep_m = 0.05;
  const auto box = [](double u0, double u1, double v0, double v1) {
    return std::vector<Vec2>{{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
  };
  ContourPiece wall;
  wall.outline = dense(box(0, 10, 0, 6), kStep_m);
  wall.area_m2 = 60;
  const Chain far = box(7, 8, 3, 4), touched = box(4.01, 5, 2, 3);
  wall.openings = {reversed_chain(far), reversed_chain(touched)};
  wall.forms.resize(2);
  const std::vector<PolygonWithHoles> cut{{box(2, 4, -0.1, 3), {}}};
  const auto parts = cut_at_border({wall}, cut, kStep_m, ContourSetting{});
  REQUIRE(parts.size() == 1);
  REQUIRE(parts[0].openings.size() == 1);
  REQUIRE(parts[0].forms.size() == 1);
  CHECK(parts[0].openings[0] == reversed_chain(far));
  CHECK(signed_area(parts[0].outline) == doctest::Approx(60 - 2 * 3 - 0.99).epsilon(0.01).scale(0));
}

TEST_CASE("contour_holes__a_place_at_the_border_of_another_piece_leaves_a_piece_as_it_is") {
  ContourPiece wall;
  wall.outline = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<PolygonWithHoles> cut{{{{5, 5}, {6, 5}, {6, 6}}, {}}};
  const auto parts = cut_at_border({wall}, cut, 0.05, ContourSetting{});
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].outline == wall.outline);
}
