// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Planes of surfaces made by hand, whose cells are counted.

#include <doctest/doctest.h>

#include "registration/coarse/planes.h"
#include "unit/registration/coarse_surfaces.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::vector<CoarsePlane> planes_of(const Cells& cells, size_t most = 100) {
  Task task;
  return coarse_planes(cells.surface(), most, task);
}

// The plane through a point with a normal of either sign.
bool is_plane(const CoarsePlane& found, const Vec3& point, const Vec3& normal) {
  return norm(cross(found.plane.normal, normalized(normal))) < 1e-9 &&
         std::abs(found.plane.distance(point)) < 1e-9;
}

// Floor of 120 cells, walls of 60 and 20, and 19 cells that are too few; all of them far apart.
Cells four_sheets() {
  return Cells()
      .sheet({40, 0, 3}, {0, 1, 0}, {0, 0, 1}, 5, 4)
      .sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 10, 12)
      .sheet({20, 0, 0}, {0.6, 0.8, 0}, {0, 0, 1}, 10, 6)
      .sheet({60, 0, 0}, {1, 0, 0}, {0, 0.6, 0.8}, 19, 1);
}

}  // namespace

TEST_CASE("coarse_planes__count_every_cell_of_a_sheet_and_begin_with_the_largest") {
  const auto planes = planes_of(four_sheets());
  REQUIRE(planes.size() == 3);
  CHECK(planes[0].cells == 120);
  CHECK(is_plane(planes[0], {3, 3, 0}, {0, 0, 1}));
  CHECK(planes[1].cells == 60);
  CHECK(is_plane(planes[1], {20, 0, 0}, {0.8, -0.6, 0}));
  CHECK(planes[2].cells == 20);
  CHECK(is_plane(planes[2], {40, 0, 0}, {1, 0, 0}));
  const auto two = planes_of(four_sheets(), 2);
  REQUIRE(two.size() == 2);
  CHECK(two[1].cells == 60);
  CHECK(planes_of(four_sheets(), 0).empty());
}

TEST_CASE("coarse_planes__coplanar_sheets_are_one_whatever_side_their_normals_show") {
  Cells cells;
  cells.sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 5, 8);    // 40
  cells.sheet({15, 0, 0}, {0, 1, 0}, {1, 0, 0}, 7, 5);   // 35 of the same plane, from below
  cells.sheet({0, 30, 0}, {0, 0, 1}, {1, 0, 0}, 10, 6);  // a wall of 60
  cells.sheet({0, 50, 1}, {1, 0, 0}, {0, 1, 0}, 5, 5);   // 25 a cell higher
  const auto planes = planes_of(cells);
  REQUIRE(planes.size() == 3);
  CHECK(planes[0].cells == 75);
  CHECK(is_plane(planes[0], {0, 0, 0}, {0, 0, 1}));
  CHECK(planes[1].cells == 60);
  CHECK(planes[2].cells == 25);
  CHECK(is_plane(planes[2], {0, 0, 1}, {0, 0, 1}));
}

TEST_CASE("coarse_planes__meet_at_an_edge_without_taking_each_others_cells") {
  // Both begin one cell from the edge, so that each cell belongs to one plane.
  const auto planes = planes_of(Cells()
                                    .sheet({1, 0, 0}, {1, 0, 0}, {0, 1, 0}, 8, 9)
                                    .sheet({0, 0, 1}, {0, 1, 0}, {0, 0, 1}, 9, 6));
  REQUIRE(planes.size() == 2);
  CHECK(planes[0].cells == 72);
  CHECK(planes[1].cells == 54);
}

TEST_CASE("coarse_planes__a_step_of_a_cell_up_or_down_parts_them") {
  const auto planes = planes_of(Cells()
                                    .sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 8, 9)
                                    .sheet({8, 0, -1}, {1, 0, 0}, {0, 1, 0}, 7, 9)
                                    .sheet({-6, 0, 1}, {1, 0, 0}, {0, 1, 0}, 6, 9));
  REQUIRE(planes.size() == 3);
  CHECK(planes[0].cells == 72);
  CHECK(planes[1].cells == 63);
  CHECK(planes[2].cells == 54);
}

TEST_CASE("coarse_planes__of_a_small_ball_and_of_broken_ground_there_are_none") {
  // 79 cells on a radius of 2.5: 0.4 cells to either side of a plane leave a cap of 13.
  Cells ball;
  for (const Vec3& p : sphere(79)) ball.add(p * 2.5, p);
  CHECK(planes_of(ball).empty());
  CoarseSurface broken = Cells().sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 10, 10).surface();
  Task task;
  REQUIRE(coarse_planes(broken, 10, task).size() == 1);
  broken.variation.assign(broken.size(), 0.05);
  CHECK(coarse_planes(broken, 10, task).empty());
}
