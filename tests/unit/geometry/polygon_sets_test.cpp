// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/random.h"
#include "geometry/polygon2.h"
#include "geometry/polygon_sets.h"

using namespace jalon;

namespace {

using Polygons = std::vector<PolygonWithHoles>;

PolygonWithHoles box(double left, double bottom, double right, double top) {
  return {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, {}};
}

double area_of(const Polygons& polygons) {
  double sum = 0;
  for (const auto& p : polygons) {
    sum += signed_area(p.outline);
    for (const auto& hole : p.holes) sum += signed_area(hole);
  }
  return sum;
}

double area(SetOperation operation, const Polygons& a, const Polygons& b) {
  return area_of(combined(operation, a, b));
}

bool covers(const Polygons& polygons, const Vec2& p) {
  for (const auto& polygon : polygons) {
    if (!contains(polygon.outline, p)) continue;
    bool in_hole = false;
    for (const auto& hole : polygon.holes) in_hole = in_hole || contains(hole, p);
    if (!in_hole) return true;
  }
  return false;
}

// Nearer to a border than the grid can tell.
bool near_border(const Polygons& polygons, const Vec2& p) {
  for (const auto& polygon : polygons) {
    double d = border_distance(polygon.outline, p);
    for (const auto& hole : polygon.holes) d = std::min(d, border_distance(hole, p));
    if (d < 2 * kPolygonGrid_m) return true;
  }
  return false;
}

// A star-shaped polygon, so that it is simple; holes inside it.
PolygonWithHoles star(const Vec2& centre, double radius, int corners, bool with_hole,
                      RandomStream& random) {
  PolygonWithHoles out;
  const auto ring = [&](double from, double to) {
    std::vector<Vec2> corners_of;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.8 * random.uniform()) / corners,
                   r = radius * (from + (to - from) * random.uniform());
      corners_of.push_back(centre + Vec2{r * std::cos(angle), r * std::sin(angle)});
    }
    return corners_of;
  };
  out.outline = ring(0.6, 1);
  if (with_hole) out.holes.push_back(ring(0.1, 0.4));
  return out;
}

}  // namespace

TEST_CASE("polygon_sets__count_areas_of_rectangles_by_hand") {
  const Polygons a{box(0, 0, 4, 3)}, b{box(2, 1, 6, 5)};
  CHECK(area(SetOperation::kIntersection, a, b) == doctest::Approx(4).epsilon(1e-12));
  CHECK(area(SetOperation::kUnion, a, b) == doctest::Approx(24).epsilon(1e-12));
  CHECK(area(SetOperation::kDifference, a, b) == doctest::Approx(8).epsilon(1e-12));
  CHECK(area(SetOperation::kXor, a, b) == doctest::Approx(20).epsilon(1e-12));
  const SharedArea shared = shared_area(a, b);
  CHECK(shared.a == doctest::Approx(12).epsilon(1e-12));
  CHECK(shared.b == doctest::Approx(16).epsilon(1e-12));
  CHECK(shared.both == doctest::Approx(4).epsilon(1e-12));
}

TEST_CASE("polygon_sets__give_a_region_against_itself_the_same_area_thrice") {
  RandomStream random(4, 1);
  for (int k = 0; k < 20; ++k) {
    const Polygons p{star({3, 2}, 5, 9, true, random), star({20, -4}, 3, 6, false, random)};
    const SharedArea shared = shared_area(p, p);
    CHECK(shared.a == shared.b);
    CHECK(shared.a == shared.both);
    CHECK(combined(SetOperation::kDifference, p, p).empty());
    CHECK(combined(SetOperation::kXor, p, p).empty());
  }
}

TEST_CASE("polygon_sets__take_degenerate_input") {
  const Polygons none, square{box(0, 0, 1, 1)};
  CHECK(combined(SetOperation::kIntersection, none, square).empty());
  CHECK(area(SetOperation::kUnion, none, square) == doctest::Approx(1));
  CHECK(area(SetOperation::kDifference, square, none) == doctest::Approx(1));
  const Polygons flat{{{{0, 0}, {1, 0}, {2, 0}}, {}},
                      {{{0, 0}, {1, 1}}, {}},
                      {{}, {}},
                      {{{5, 5}, {5, 5}, {5, 5}}, {}}};
  CHECK(region_area(flat) == 0);
  CHECK(area(SetOperation::kUnion, flat, square) == doctest::Approx(1));
  // Sharing an edge, part of an edge, a corner.
  CHECK(area(SetOperation::kIntersection, square, {box(1, 0, 2, 1)}) == 0);
  CHECK(combined(SetOperation::kUnion, square, Polygons{box(1, 0, 2, 1)}).size() == 1);
  CHECK(area(SetOperation::kUnion, square, {box(1, 0.25, 2, 0.5)}) == doctest::Approx(1.25));
  CHECK(area(SetOperation::kXor, square, {box(1, 1, 2, 2)}) == doctest::Approx(2));
  // Corners on straight edges, and a repeated corner, change nothing.
  const Polygons more{{{{0, 0}, {0.5, 0}, {0.5, 0}, {1, 0}, {1, 0.3}, {1, 1}, {0, 1}}, {}}};
  CHECK(combined(SetOperation::kXor, square, more).empty());
  // A hole that fills its outline, and one that touches it.
  CHECK(region_area(Polygons{{square[0].outline, {square[0].outline}}}) == 0);
  CHECK(region_area(Polygons{{square[0].outline, {box(0, 0.5, 0.5, 1).outline}}}) ==
        doctest::Approx(0.75));
}

TEST_CASE("polygon_sets__take_either_orientation_and_overlapping_polygons") {
  Polygons turned{box(0, 0, 4, 4)};
  turned[0].holes = {box(1, 1, 2, 2).outline};
  std::reverse(turned[0].outline.begin(), turned[0].outline.end());
  CHECK(region_area(turned) == doctest::Approx(15));
  std::reverse(turned[0].holes[0].begin(), turned[0].holes[0].end());
  CHECK(region_area(turned) == doctest::Approx(15));
  // A second polygon fills the hole of the first: its union has none.
  CHECK(region_area(Polygons{turned[0], box(0.5, 0.5, 2.5, 2.5)}) == doctest::Approx(16));
  CHECK(region_area(Polygons{box(0, 0, 2, 1), box(1, 0, 3, 1)}) == doctest::Approx(3));
  const auto ring =
      combined(SetOperation::kDifference, Polygons{box(0, 0, 4, 4)}, Polygons{box(1, 1, 2, 2)});
  REQUIRE(ring.size() == 1);
  REQUIRE(ring[0].holes.size() == 1);
  CHECK(signed_area(ring[0].outline) > 0);
  CHECK(signed_area(ring[0].holes[0]) < 0);
}

TEST_CASE("polygon_sets__give_simple_rings_where_polygons_touch") {
  // Two squares at a corner, a hole that touches its outline, two holes at a corner, a square in a hole.
  const auto corner =
      combined(SetOperation::kUnion, Polygons{box(0, 0, 1, 1)}, Polygons{box(1, 1, 2, 2)});
  CHECK(corner.size() == 2);
  const Polygons diamond{{{{0, 2}, {2, 1}, {4, 2}, {2, 3}}, {}}};
  const auto pinched = combined(SetOperation::kDifference, Polygons{box(0, 0, 6, 4)}, diamond);
  REQUIRE(pinched.size() == 1);
  CHECK(pinched[0].holes.size() == 1);
  const auto both = combined(SetOperation::kDifference, Polygons{box(0, 0, 6, 6)},
                             Polygons{box(1, 1, 2, 2), box(2, 2, 3, 3)});
  REQUIRE(both.size() == 1);
  CHECK(both[0].holes.size() == 2);
  Polygons frame{box(0, 0, 6, 6)};
  frame[0].holes = {box(1, 1, 5, 5).outline};
  const auto island = combined(SetOperation::kUnion, frame, Polygons{box(2, 2, 4, 4)});
  REQUIRE(island.size() == 2);
  CHECK(island[0].holes.size() + island[1].holes.size() == 1);
  for (const auto& made : {corner, pinched, both, island})
    for (const auto& polygon : made) {
      CHECK(is_simple(polygon.outline));
      for (const auto& hole : polygon.holes) CHECK(is_simple(hole));
    }
}

TEST_CASE("polygon_sets__agree_with_random_points") {
  RandomStream random(7, 7);
  const SetOperation operations[] = {SetOperation::kIntersection, SetOperation::kUnion,
                                     SetOperation::kDifference, SetOperation::kXor};
  double worst = 0;
  for (int round = 0; round < 25; ++round) {
    const int corners = 4 + static_cast<int>(random.below(12));
    const Polygons a{star({0, 0}, 3, corners, true, random),
                     star({5, 1}, 2, corners, false, random)};
    const Polygons b{star({1, 0.5}, 3, corners, round % 2 == 0, random),
                     star({4, -2}, 2.5, corners, true, random)};
    Polygons made[4];
    for (size_t o = 0; o < 4; ++o) made[o] = combined(operations[o], a, b);
    int wrong = 0;
    constexpr int kPoints = 2000;
    for (int k = 0; k < kPoints; ++k) {
      const Vec2 p{-4 + 12 * random.uniform(), -5 + 9 * random.uniform()};
      if (near_border(a, p) || near_border(b, p)) continue;
      const bool in_a = covers(a, p), in_b = covers(b, p);
      const bool wanted[4] = {in_a && in_b, in_a || in_b, in_a && !in_b, in_a != in_b};
      for (size_t o = 0; o < 4; ++o) wrong += covers(made[o], p) != wanted[o];
    }
    CHECK(wrong == 0);
    // Areas of the four agree among each other but for rounded crossings, half a step off along the edges.
    const double i = area_of(made[0]), u = area_of(made[1]), d = area_of(made[2]),
                 x = area_of(made[3]);
    worst = std::max({worst, std::fabs(u - i - x), std::fabs(region_area(a) - i - d)});
  }
  MESSAGE("FIGURE areas of the operations agree within ", worst, " m2");
  CHECK(worst < 0.005);
}

TEST_CASE("polygon_sets__snap_to_the_grid_and_refuse_what_does_not_fit") {
  CHECK(region_area(Polygons{box(0, 0, 1.00004, 1)}) == doctest::Approx(1).epsilon(1e-12));
  CHECK(region_area(Polygons{box(0, 0, 1.00006, 1)}) == doctest::Approx(1.0001).epsilon(1e-12));
  CHECK_THROWS_AS(region_area(Polygons{box(0, 0, 20000, 1)}), Error);
  CHECK_THROWS_AS(region_area(Polygons{box(0, 0, std::nan(""), 1)}), Error);
  CHECK(region_area(Polygons{box(0, 0, 20000, 1)}, 0.01) == doctest::Approx(20000));
}
