// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Shop fronts between piers.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/plane/ring_tools.h"
#include "modelling/walls/bays.h"
#include "unit/modelling/upright_planes.h"

using namespace jalon;
using namespace upright_planes;

namespace {

/// Four piers below a board that hides the wall from 3 to 4 m.
std::vector<VectorRing> shop_fronts() {
  return {rectangle(0, 12, 4, 7), rectangle(0, 1, 0, 3), rectangle(4, 5, 0, 3),
          rectangle(8, 9, 0, 3), rectangle(11, 12, 0, 3)};
}

void check_box(const WallHole& hole, double u0, double u1, double v0, double v1) {
  const RingBox box = ring_box(hole.outline);
  CHECK(std::fabs(box.low.u - u0) < 0.02);
  CHECK(std::fabs(box.high.u - u1) < 0.02);
  CHECK(std::fabs(box.low.v - v0) <= 2 * kSpacing_m);
  CHECK(std::fabs(box.high.v - v1) <= 2 * kSpacing_m);
}

HolePoint point(double u, double v, double w) {
  return {0, 0, static_cast<float>(u), static_cast<float>(v), static_cast<float>(w)};
}

}  // namespace

TEST_CASE("bays__between_piers_below_a_board_are_found_from_left_to_right") {
  const auto bays = bays_of(plane_of(shop_fronts()), {}, {});
  REQUIRE(bays.size() == 3);
  check_box(bays[0], 1, 4, 0, 3);
  check_box(bays[1], 5, 8, 0, 3);
  check_box(bays[2], 9, 11, 0, 3);
  for (const WallHole& bay : bays) {
    CHECK(bay.is_bay);
    CHECK(bay.outline.corners[0] == ring_box(bay.outline).low);  // the left foot
  }
}

TEST_CASE("bays__what_stands_before_a_pier_or_hangs_in_a_bay_moves_no_side") {
  auto pieces = shop_fronts();
  // A bin hides 0.8 m of the second pier, a shutter of 0.3 m2 hangs in the first bay.
  pieces[2] = rectangle(4, 5, 1.85, 3);
  pieces.push_back(rectangle(4, 5, 0, 1.05));
  pieces.push_back(rectangle(2, 2.3, 1.5, 2.5));
  const auto bays = bays_of(plane_of(std::move(pieces)), {}, {});
  REQUIRE(bays.size() >= 2);
  check_box(bays[0], 1, 4, 0, 3);
}

TEST_CASE("bays__need_wall_above_and_no_hole_in_their_place") {
  auto pieces = shop_fronts();
  pieces.erase(pieces.begin());
  CHECK(bays_of(plane_of(std::move(pieces)), {}, {}).empty());
  WallHole hole;
  hole.outline = rectangle(1.1, 3.9, 0, 2.9);
  CHECK(bays_of(plane_of(shop_fronts()), {{hole}}, {}).size() == 2);
}

TEST_CASE("bays__end_where_what_is_seen_behind_them_ends_and_empty_ways_are_none") {
  WallHole bay;
  bay.outline = rectangle(1, 4, 0, 3);
  bay.is_bay = bay.is_notch = true;
  HoleSurvey survey;
  survey.cells = 60 * 60;
  WallMap map;
  map.cell_m = kSpacing_m;
  for (double u = 1.02; u < 4; u += kSpacing_m)
    for (double v = 0.02; v < 2.2; v += kSpacing_m) survey.points.push_back(point(u, v, -0.15));
  REQUIRE(fit_to_content(bay, survey, map, 0.03));
  check_box(bay, 1, 4, 0, 2.2);
  survey.points.resize(100);
  CHECK_FALSE(fit_to_content(bay, survey, map, 0.03));
}

TEST_CASE("bays__with_another_wall_in_them_are_no_openings") {
  WallHole bay;
  bay.outline = rectangle(1, 4, 0, 3);
  const VectorPlane wall = plane_of(shop_fronts());
  CHECK(is_walled_up(bay, wall, plane_of({rectangle(0.5, 4.5, 0, 4)}, -0.14), 1));
  CHECK_FALSE(is_walled_up(bay, wall, plane_of({rectangle(0.5, 4.5, 0, 4)}, -1.4), 1));
  CHECK_FALSE(is_walled_up(bay, wall, plane_of({rectangle(3, 4.5, 0, 4)}, -0.14), 1));
}
