// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What nobody measured of a wall at the border of its faces.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/plane/ring_tools.h"
#include "modelling/walls/border_shadows.h"
#include "unit/modelling/painted_cells.h"
#include "unit/modelling/upright_planes.h"

using namespace jalon;
using namespace upright_planes;
using painted::paint;

namespace {

constexpr double kCell_m = 0.1;
// The wall is 8 x 5 m; from its left border and from its foot came no point of a band and of a stretch.
const CellBox kBand{0, 28, 50, 36}, kStretch{60, 0, 75, 20};

WallCells cells_with(WallState band, WallState stretch) {
  WallCells cells = painted::cells_of(80, 50, WallState::kOn, kCell_m);
  paint(cells, kBand, band);
  paint(cells, kStretch, stretch);
  return cells;
}
// Its face ends a third of a cell before the points that nobody has of it.
VectorPlane wall_round_both() {
  return plane_of({ring_of({{0, 0},
                            {6.03, 0},
                            {6.03, 1.97},
                            {7.47, 1.97},
                            {7.47, 0},
                            {8, 0},
                            {8, 5},
                            {0, 5},
                            {0, 3.57},
                            {4.97, 3.57},
                            {4.97, 2.83},
                            {0, 2.83}})});
}
std::vector<FacadeShadow> shadows_of(const FacadeWall& wall, const WallCells& cells) {
  Task task;
  return border_shadows(wall_round_both(), wall, cells, {}, task);
}
double area_of(const FacadeShadow& shadow) { return signed_area(shadow.outline); }

}  // namespace

TEST_CASE("border_shadows__what_nobody_measured_lies_beside_the_face_and_meets_it") {
  const auto shadows = shadows_of({}, cells_with(WallState::kHidden, WallState::kEmpty));
  REQUIRE(shadows.size() == 2);
  double sum_m2 = 0;
  for (const FacadeShadow& shadow : shadows) {
    sum_m2 += area_of(shadow);
    CHECK_FALSE(shadow.is_filled);
    CHECK(shadow.is_notch);
    CHECK(is_simple(shadow.outline, 0.001));
  }
  // All that the face leaves of the wall's box, and nothing of the face.
  CHECK(sum_m2 ==
        doctest::Approx(40 - signed_area(wall_round_both().faces[0].outline)).epsilon(1e-4));
}

TEST_CASE("border_shadows__what_was_seen_through_or_lies_beyond_the_wall_is_none") {
  CHECK(shadows_of({}, cells_with(WallState::kThrough, WallState::kOutside)).empty());
  CHECK(shadows_of({}, cells_with(WallState::kDeep, WallState::kOutside)).empty());
  CHECK(shadows_of({}, cells_with(WallState::kProud, WallState::kOutside)).size() == 1);
}

TEST_CASE("border_shadows__an_opening_at_the_border_takes_its_place") {
  FacadeWall wall;
  wall.openings.emplace_back().outline = rectangle(6.03, 7.47, 0, 1.2);
  const auto shadows = shadows_of(wall, cells_with(WallState::kThrough, WallState::kEmpty));
  REQUIRE(shadows.size() == 1);
  CHECK(area_of(shadows[0]) == doctest::Approx(1.44 * 0.77).epsilon(1e-3));
  // And a shadow that the wall's outline had as a notch.
  FacadeWall told;
  told.shadows.push_back({rectangle(6.03, 7.47, 0, 1.97), 0, true, false});
  CHECK(shadows_of(told, cells_with(WallState::kThrough, WallState::kEmpty)).empty());
}

TEST_CASE("border_shadows__small_ones_are_left_out_and_a_ring_about_an_opening_is_slit") {
  WallCells cells = painted::cells_of(80, 50, WallState::kOn, kCell_m);
  paint(cells, {60, 0, 62, 2}, WallState::kEmpty);
  Task task;
  const VectorPlane notched =
      plane_of({ring_of({{0, 0}, {6, 0}, {6, 0.2}, {6.2, 0.2}, {6.2, 0}, {8, 0}, {8, 5}, {0, 5}})});
  CHECK(border_shadows(notched, {}, cells, {}, task).empty());
  FacadeWall wall;
  wall.openings.emplace_back().outline = rectangle(6.5, 7, 0.5, 1.5);
  double sum_m2 = 0;
  for (const FacadeShadow& shadow :
       shadows_of(wall, cells_with(WallState::kThrough, WallState::kEmpty)))
    sum_m2 += area_of(shadow);
  CHECK(sum_m2 == doctest::Approx(1.44 * 1.97 - 0.5).epsilon(0.03).scale(0));
}

TEST_CASE("border_shadows__some_points_amid_it_cut_no_place_into_strips") {
  WallCells cells = cells_with(WallState::kThrough, WallState::kHidden);
  // Points between leaves, and a look past them, every third cell.
  for (uint32_t c = 62; c < 74; c += 3)
    for (uint32_t r = 2; r < 18; r += 3)
      paint(cells, {c, r, c + 1, r + 1}, (r + c) % 2 == 0 ? WallState::kOn : WallState::kThrough);
  const auto shadows = shadows_of({}, cells);
  REQUIRE(shadows.size() == 1);
  CHECK(area_of(shadows[0]) == doctest::Approx(1.44 * 1.97).epsilon(1e-3).scale(0));
}

TEST_CASE("border_shadows__a_strip_at_the_foot_takes_no_place_beside_it_away") {
  WallCells cells = cells_with(WallState::kThrough, WallState::kHidden);
  paint(cells, {0, 0, 80, 1}, WallState::kHidden);
  // The wall ends above the strip.
  const VectorPlane raised = plane_of({ring_of({{0, 0.07},
                                                {6.03, 0.07},
                                                {6.03, 1.97},
                                                {7.47, 1.97},
                                                {7.47, 0.07},
                                                {8, 0.07},
                                                {8, 5},
                                                {0, 5}})});
  Task task;
  const auto shadows = border_shadows(raised, {}, cells, {}, task);
  REQUIRE(shadows.size() == 1);
  const RingBox box = ring_box(shadows[0].outline);
  CHECK(box.width() < 1.75);
  CHECK(area_of(shadows[0]) > 1.44 * 1.97 - 0.01);
}
