// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Walls that belong to one facade.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/walls/facade_groups.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

namespace {

/// A rectangle on the plane this far before y = 0.
VectorPlane wall_at(const Vec2& low, const Vec2& high, double before_m) {
  return wall_of({{rectangle(low, high), {}}}, 0.02, before_m);
}

/// The same looking along +x, at x = 0, from y = from to y = to.
VectorPlane side_wall(double from, double to, double height) {
  VectorPlane out = wall_of({{rectangle({from, 0}, {to, height}), {}}}, 0.02);
  out.frame = {{}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, 0};
  return out;
}

}  // namespace

TEST_CASE("facade_groups__parallel_walls_near_the_main_one_are_its_facade_the_others_their_own") {
  const std::vector<VectorPlane> planes{wall_at({0, 0}, {4, 4}, -1),    // set back by 1 m
                                        wall_at({0, 0}, {10, 8}, 0),    // the main one
                                        wall_at({11, 0}, {15, 5}, 0),   // beside it
                                        wall_at({0, 0}, {9, 7}, -30),   // another house
                                        side_wall(0, 6, 8),             // round the corner
                                        wall_at({2, 9}, {3, 9.5}, 0)};  // too small for a wall
  const auto groups = group_facades(planes, {});
  REQUIRE(groups.size() == 3);
  CHECK(groups[0].walls == std::vector<size_t>{1, 2, 0});  // by falling area
  CHECK(groups[1].walls == std::vector<size_t>{3});
  CHECK(groups[2].walls == std::vector<size_t>{4});
  CHECK(groups[0].others == std::vector<size_t>{5});
  CHECK(groups[1].others.empty());
  const FacadeFrame& f = groups[0].frame;
  CHECK(norm(f.outward - Vec3{0, -1, 0}) < 1e-12);
  CHECK(norm(f.along - Vec3{1, 0, 0}) < 1e-12);
  CHECK(norm(f.local({3, -2, 5}) - Vec3{3, 2, 5}) < 1e-12);
  CHECK(groups[0].box.max.x == doctest::Approx(15));
  CHECK(groups[0].box.min.y == doctest::Approx(-1));
}

TEST_CASE("facade_groups__a_pane_in_a_walls_hole_is_no_wall") {
  VectorPlane front = wall_at({0, 0}, {10, 8}, 0);
  front.faces[0].openings.push_back(hole({2, 2}, {6, 6}));
  const auto groups = group_facades({front, wall_at({2.1, 2.1}, {5.9, 5.9}, -0.2)}, {});
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].walls == std::vector<size_t>{0});
  CHECK(groups[0].others == std::vector<size_t>{1});
  // Behind the wall itself it is one.
  CHECK(group_facades({front, wall_at({6.1, 2.1}, {9.9, 5.9}, -0.2)}, {})[0].walls.size() == 2);
}

TEST_CASE("facade_groups__without_a_wall_one_group_holds_all_planes_that_have_faces") {
  VectorPlane floor = wall_at({0, 0}, {10, 10}, 0);
  floor.frame = {{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0};
  const auto groups = group_facades({floor, wall_at({0, 0}, {1, 1}, 0), wall_of({}, 0.02)}, {});
  REQUIRE(groups.size() == 1);
  CHECK(groups[0].walls.empty());
  CHECK(groups[0].others == std::vector<size_t>{0, 1});
  CHECK(group_facades({}, {}).size() == 1);
  // A post is long enough but too narrow.
  CHECK(group_facades({wall_at({0, 0}, {0.5, 12}, 0)}, {})[0].walls.empty());
  CHECK(outline_corners(floor).size() == 4);
  CHECK(outline_corners(floor)[2] == Vec3{10, 10, 0});
}

TEST_CASE("facade_groups__a_wall_told_as_a_recess_stays_one_in_a_walls_hole") {
  VectorPlane front = wall_at({0, 0}, {10, 8}, 0);
  front.faces[0].openings.push_back(hole({2, 2}, {6, 6}));
  const std::vector<VectorPlane> planes{front, wall_at({2.1, 2.1}, {5.9, 5.9}, -1.4)};
  std::vector<WallClaim> claims{{false, false, true, 80, 64}, {false, false, false, 14.4, 12}};
  CHECK(group_facades(planes, {}, claims)[0].walls == std::vector<size_t>{0});
  claims[1].is_recess = true;
  CHECK(group_facades(planes, {}, claims)[0].walls == std::vector<size_t>{0, 1});
}

TEST_CASE("facade_groups__a_bay_window_before_a_walls_hole_is_a_wall_and_a_blank_parapet_is_none") {
  VectorPlane front = wall_at({0, 0}, {10, 8}, 0);
  front.faces[0].openings.push_back(hole({2, 2}, {6, 6}));
  const std::vector<VectorPlane> planes{front, wall_at({2.1, 2.1}, {5.9, 5.9}, 0.9)},
      behind{front, wall_at({2.1, 2.1}, {5.9, 5.9}, -0.9)};
  std::vector<WallClaim> claims{{false, false, true, 80, 64}, {false, false, false, 14.4, 12}};
  CHECK(group_facades(planes, {}, claims)[0].walls == std::vector<size_t>{0});
  claims[1].is_windowed = true;
  CHECK(group_facades(planes, {}, claims)[0].walls == std::vector<size_t>{0, 1});
  CHECK(group_facades(behind, {}, claims)[0].walls == std::vector<size_t>{0});
}
