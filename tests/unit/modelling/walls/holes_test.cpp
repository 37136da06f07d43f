// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Where a wall's face is interrupted.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "modelling/walls/holes.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

TEST_CASE("wall holes: a doorway in the lower border is a notch, the end of a wall is none") {
  VectorPlane wall;
  wall.faces.push_back(
      {ring_of({{0, 0}, {2, 0}, {2, 2.1}, {3, 2.1}, {3, 0.05}, {8, 0}, {8, 5}, {0, 5}}), {}});
  const auto holes = holes_of(wall, {});
  REQUIRE(holes.size() == 1);
  CHECK(holes[0].is_notch);
  CHECK(holes[0].outline.corners == std::vector<Vec2>{{2, 0}, {3, 0.05}, {3, 2.1}, {2, 2.1}});
  CHECK(signed_area(holes[0].outline) > 0);
  VectorFace closed = wall.faces[0];
  close_hole(closed, holes[0]);
  CHECK(closed.outline.corners.size() == 6);
  CHECK(closed.outline.edges.size() == 6);
  CHECK(std::abs(signed_area(closed.outline) - 40) < 0.2);
  // Too low, or too wide: steps in the border.
  wall.faces[0].outline = ring_of({{0, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 0}, {8, 0}, {8, 5}, {0, 5}});
  CHECK(holes_of(wall, {}).empty());
  wall.faces[0].outline =
      ring_of({{0, 0}, {0.5, 0}, {0.5, 3}, {7.5, 3}, {7.5, 0}, {8, 0}, {8, 5}, {0, 5}});
  CHECK(holes_of(wall, {}).empty());
}

TEST_CASE("wall holes: a hole that is closed leaves the others") {
  VectorPlane wall;
  const VectorRing first = ring_of({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
  const VectorRing second = ring_of({{4, 1}, {4, 2}, {5, 2}, {5, 1}});
  wall.faces.push_back({ring_of({{0, 0}, {8, 0}, {8, 5}, {0, 5}}), {first, second}});
  const auto holes = holes_of(wall, {});
  REQUIRE(holes.size() == 2);
  close_hole(wall.faces[0], holes[0]);
  REQUIRE(wall.faces[0].openings.size() == 1);
  CHECK(wall.faces[0].openings[0].corners == second.corners);
}

TEST_CASE("wall_holes__come_by_face_and_opening_and_then_the_notches_from_left_to_right") {
  const VectorRing doors = ring_of({{0, 0},
                                    {1, 0},
                                    {1, 2.5},
                                    {2, 2.5},
                                    {2, 0},
                                    {5, 0},
                                    {5, 2.5},
                                    {6, 2.5},
                                    {6, 0},
                                    {9, 0},
                                    {9, 6},
                                    {0, 6}});
  VectorRing turned = doors;  // beginning between the doors
  std::rotate(turned.corners.begin(), turned.corners.begin() + 5, turned.corners.end());
  const VectorPlane wall = wall_of({{rectangle({20, 0}, {25, 6}), {hole({21, 1}, {22, 2})}},
                                    {turned, {hole({3, 3}, {4, 4}), hole({1, 4}, {2, 5})}}},
                                   0.02);
  const auto holes = holes_of(wall, {});
  REQUIRE(holes.size() == 5);
  const uint32_t pieces[] = {0, 1, 1, 1, 1};
  for (size_t k = 0; k < 5; ++k) {
    CHECK(holes[k].piece == pieces[k]);
    CHECK(holes[k].is_notch == (k >= 3));
    CHECK(!holes[k].is_bay);
    CHECK(signed_area(holes[k].outline) > 0);
  }
  CHECK(holes[3].outline.corners[0] == Vec2{1, 0});
  CHECK(holes[4].outline.corners[0] == Vec2{5, 0});
  VectorFace face = wall.faces[1];
  close_hole(face, holes[3]);
  CHECK(signed_area(face.outline) == doctest::Approx(54 - 2.5));
  CHECK(face.openings.size() == 2);
  close_hole(face, holes[4]);
  CHECK(signed_area(face.outline) == doctest::Approx(54));
}

TEST_CASE("wall_holes__an_arched_doorway_keeps_its_arc") {
  VectorRing outline = ring_of({{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 0}, {9, 0}, {9, 6}, {0, 6}});
  outline.edges[2].sagitta_m = -1;  // the head, out of the face
  const auto holes = holes_of(wall_of({{outline, {}}}, 0.02), {});
  REQUIRE(holes.size() == 1);
  CHECK(signed_area(holes[0].outline) == doctest::Approx(4 + std::numbers::pi / 2));
}
