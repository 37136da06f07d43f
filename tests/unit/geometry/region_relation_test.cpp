// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/region_relation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "base/random.h"

using namespace jalon;

namespace {

using Regions = std::vector<PolygonWithHoles>;
using RegionMatrix = std::array<int8_t, 9>;
constexpr double kTolerance = 0.001;

std::vector<Vec2> ring(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}
Regions box(double left, double bottom, double right, double top) {
  return {{ring(left, bottom, right, top), {}}};
}
Regions frame(const std::vector<Vec2>& outline, const std::vector<Vec2>& hole) {
  return {{outline, {hole}}};
}

// Turned about a far point and moved by seven digits less, as facades lie in their planes.
Regions turned(Regions regions, double angle, const Vec2& shift) {
  const auto turn = [&](std::vector<Vec2>& corners) {
    for (Vec2& p : corners)
      p = Vec2{std::cos(angle) * p.u - std::sin(angle) * p.v,
               std::sin(angle) * p.u + std::cos(angle) * p.v} +
          shift;
  };
  for (PolygonWithHoles& polygon : regions) {
    turn(polygon.outline);
    for (auto& hole : polygon.holes) turn(hole);
  }
  return regions;
}

// However both lie in the plane and whichever is asked first.
void check(const Regions& a, const Regions& b, const RegionMatrix& matrix, const char* name) {
  RandomStream random(7, 0);
  for (int k = 0; k < 8; ++k) {
    const double angle = k == 0 ? 0 : 6.3 * random.uniform();
    const Vec2 shift{k == 0 ? 0 : 1000 * random.uniform(), k == 0 ? 0 : 1000 * random.uniform()};
    CAPTURE(angle);
    const Regions p = turned(a, angle, shift), q = turned(b, angle, shift);
    const NineIntersection found = region_intersection(p, q, kTolerance);
    CHECK(found.dimensions == matrix);
    CHECK(name_of(relation_of(found)) == std::string(name));
    CHECK(region_intersection(q, p, kTolerance) == found.transposed());
  }
}

}  // namespace

TEST_CASE("region_relation__the_eight_relations_of_two_rectangles_with_their_matrices") {
  const Regions wall = box(0, 0, 4, 3);
  check(wall, box(5, 0, 6, 1), {-1, -1, 1, -1, -1, 2, 1, 2, 2}, "disjoint");
  check(wall, box(4, 1, 6, 2), {1, -1, 1, -1, -1, 2, 1, 2, 2}, "meet");
  check(wall, box(3, 2, 6, 5), {0, 1, 1, 1, 2, 2, 1, 2, 2}, "overlap");
  check(wall, box(1, 0, 2, 2), {1, -1, 1, 1, 2, 2, -1, -1, 2}, "covers");
  check(wall, box(1, 1, 2, 2), {-1, -1, 1, 1, 2, 2, -1, -1, 2}, "contains");
  check(wall, wall, {1, -1, -1, -1, 2, -1, -1, -1, 2}, "equal");
  check(box(1, 0, 2, 2), wall, {1, 1, -1, -1, 2, -1, 1, 2, 2}, "covered_by");
  check(box(1, 1, 2, 2), wall, {-1, 1, -1, -1, 2, -1, 1, 2, 2}, "inside");
}

TEST_CASE("region_relation__a_corner_alone_is_a_contact_of_dimension_0") {
  check(box(0, 0, 1, 1), box(1, 1, 2, 2), {0, -1, 1, -1, -1, 2, 1, 2, 2}, "meet");
  // A corner on the middle of a side.
  check(box(0, 0, 1, 1), {{{{1, 0.5}, {2, 0}, {2, 1}}, {}}}, {0, -1, 1, -1, -1, 2, 1, 2, 2},
        "meet");
  // A corner that touches from within.
  check(box(0, 0, 1, 1), {{{{1, 0.5}, {0.5, 0.8}, {0.5, 0.2}}, {}}}, {0, -1, 1, 1, 2, 2, -1, -1, 2},
        "covers");
}

TEST_CASE("region_relation__overlap_along_a_common_side_shares_a_line_of_the_borders") {
  check(box(0, 0, 4, 3), box(2, 0, 6, 3), {1, 1, 1, 1, 2, 2, 1, 2, 2}, "overlap");
}

TEST_CASE("region_relation__what_fills_a_hole_meets_and_what_lies_in_it_is_disjoint") {
  const Regions wall = frame(ring(0, 0, 4, 3), ring(1, 1, 2, 2));
  check(wall, box(1, 1, 2, 2), {1, -1, 1, -1, -1, 2, -1, 2, 2}, "meet");
  check(wall, box(1.2, 1.2, 1.8, 1.8), {-1, -1, 1, -1, -1, 2, 1, 2, 2}, "disjoint");
  check(wall, box(0.5, 0.5, 2.5, 2.5), {-1, 1, 1, 1, 2, 2, -1, 2, 2}, "overlap");
  check(wall, box(0, 0, 4, 3), {1, 1, -1, -1, 2, -1, -1, 2, 2}, "covered_by");
}

TEST_CASE("region_relation__of_two_pieces_one_may_equal_the_other_region") {
  Regions two = box(0, 0, 1, 1);
  two.push_back(box(3, 0, 4, 1)[0]);
  check(two, box(3, 0, 4, 1), {1, -1, 1, -1, 2, 2, -1, -1, 2}, "covers");
  check(two, box(1.5, 0, 2.5, 1), {-1, -1, 1, -1, -1, 2, 1, 2, 2}, "disjoint");
}

TEST_CASE("region_relation__what_differs_by_less_than_the_tolerance_is_equal") {
  const Regions wall = box(0, 0, 4, 3);
  const auto relation = [&](const Regions& other) {
    return relation_of(region_intersection(wall, other, kTolerance));
  };
  for (const double off : {0.0006, -0.0006}) {
    CHECK(relation(box(off, off, 4 + off, 3 - off)) == RegionRelation::kEqual);
    CHECK(relation(box(4 + off, 0, 5, 3)) == RegionRelation::kMeet);
    CHECK(relation(box(1, off, 2, 2)) == RegionRelation::kCovers);
  }
  CHECK(relation(box(4.002, 0, 5, 3)) == RegionRelation::kDisjoint);
  CHECK(relation(box(3.998, 0, 5, 3)) == RegionRelation::kOverlap);
  CHECK(relation(box(1, 0.002, 2, 2)) == RegionRelation::kContains);
}

TEST_CASE("region_relation__cuts_lie_at_crossings_and_beside_corners") {
  const Regions wall = box(1, 0, 3, 2);
  const auto cuts = cuts_of({{0, 1}, {4, 1}}, PlaneRegion(wall).edges(), kTolerance);
  REQUIRE(cuts.size() == 4);
  CHECK(cuts[1] == doctest::Approx(0.25));
  CHECK(cuts[2] == doctest::Approx(0.75));
  CHECK(cuts_of({{0, 2}, {4, 2}}, PlaneRegion(wall).edges(), kTolerance).size() >= 4);
  CHECK(cuts_of({{0, 5}, {4, 5}}, PlaneRegion(wall).edges(), kTolerance).size() == 2);
  CHECK(PlaneRegion(wall).place_of({2, 1}, kTolerance) == NineIntersection::kInterior);
  CHECK(PlaneRegion(wall).place_of({2, 2}, kTolerance) == NineIntersection::kBoundary);
  CHECK(PlaneRegion(wall).place_of({2, 3}, kTolerance) == NineIntersection::kExterior);
  const Regions hollow = frame(ring(0, 0, 4, 3), ring(1, 1, 2, 2));
  const PlaneRegion region(hollow);
  const auto inner = region.inner_points();
  REQUIRE(inner.size() == 1);
  CHECK(region.place_of(inner[0], 0.3) == NineIntersection::kInterior);
}
