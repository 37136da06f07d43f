// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/face_relation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace jalon;

namespace {

using FaceMatrix = std::array<int8_t, 9>;
constexpr double kFaceTolerance_m = 0.001;

PlacedFace face(const std::vector<std::vector<Vec3>>& rings) {
  const auto& p = rings[0];
  return placed(rings, normalized(cross(p[1] - p[0], p[2] - p[0])));
}
PlacedFace wall() { return face({{{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {0, 0, 3}}}); }
/// A level slab at this height, from y0 to y1.
PlacedFace slab(double y0, double y1, double z, double x0 = 1, double x1 = 3) {
  return face({{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}});
}

void check_faces(const PlacedFace& a, const PlacedFace& b, const FaceMatrix& matrix,
                 const char* name) {
  CAPTURE(std::string(name));
  const NineIntersection found = face_intersection(a, b, kFaceTolerance_m);
  CHECK(found.dimensions == matrix);
  CHECK(name_of(relation_of(found)) == std::string(name));
  CHECK(face_intersection(b, a, kFaceTolerance_m) == found.transposed());
}

}  // namespace

TEST_CASE("face_relation__of_faces_in_one_plane_is_that_of_their_regions") {
  const PlacedFace window = face({{{1, 0, 1}, {2, 0, 1}, {2, 0, 2}, {1, 0, 2}}});
  check_faces(wall(), window, {-1, -1, 1, 1, 2, 2, -1, -1, 2}, "contains");
  const PlacedFace hollow = face(
      {{{0, 0, 0}, {4, 0, 0}, {4, 0, 3}, {0, 0, 3}}, {{1, 0, 1}, {1, 0, 2}, {2, 0, 2}, {2, 0, 1}}});
  check_faces(hollow, window, {1, -1, 1, -1, -1, 2, -1, 2, 2}, "meet");
  // Seen from the other side it is the same.
  const PlacedFace back = face({{{0, 0, 0}, {0, 0, 3}, {4, 0, 3}, {4, 0, 0}}});
  check_faces(wall(), back, {1, -1, -1, -1, 2, -1, -1, -1, 2}, "equal");
}

TEST_CASE("face_relation__surfaces_that_meet_at_an_angle_share_what_their_common_line_holds") {
  // A slab that ends at the wall, one that runs through it, one on its foot, one beside it and one with a gap.
  check_faces(wall(), slab(-1, 0, 1), {-1, -1, 1, 1, -1, 2, 1, 2, 3}, "meet");
  check_faces(wall(), slab(-1, 1, 1), {-1, -1, 1, 0, 1, 2, 1, 2, 3}, "overlap");
  check_faces(wall(), slab(-1, 0, 0), {1, -1, 1, -1, -1, 2, 1, 2, 3}, "meet");
  check_faces(wall(), slab(-1, 0, 1, 4, 6), {0, -1, 1, -1, -1, 2, 1, 2, 3}, "meet");
  check_faces(wall(), slab(-1, -0.01, 1), {-1, -1, 1, -1, -1, 2, 1, 2, 3}, "disjoint");
  check_faces(wall(), slab(-1, -0.0005, 1), {-1, -1, 1, 1, -1, 2, 1, 2, 3}, "meet");
  check_faces(wall(), slab(-1, 1, 1, 5, 6), {-1, -1, 1, -1, -1, 2, 1, 2, 3}, "disjoint");
}

TEST_CASE("face_relation__parallel_surfaces_apart_are_disjoint") {
  const PlacedFace pane = face({{{1, 0.2, 1}, {2, 0.2, 1}, {2, 0.2, 2}, {1, 0.2, 2}}});
  check_faces(wall(), pane, {-1, -1, 1, -1, -1, 2, 1, 2, 3}, "disjoint");
  CHECK(face_distance(wall(), pane, kFaceTolerance_m) == doctest::Approx(0.2));
}

TEST_CASE("face_relation__distances_of_surfaces") {
  CHECK(face_distance(wall(), slab(-1, -0.3, 1), kFaceTolerance_m) == doctest::Approx(0.3));
  CHECK(face_distance(wall(), slab(-1, 0, 1), kFaceTolerance_m) == 0);
  CHECK(face_distance(wall(), slab(-1, 1, 3.5), kFaceTolerance_m) == doctest::Approx(0.5));
  CHECK(face_distance(wall(), slab(-5, -3, 7), kFaceTolerance_m) == doctest::Approx(5));
  CHECK(face_distance(slab(-5, -3, 7), wall(), kFaceTolerance_m) == doctest::Approx(5));
}

TEST_CASE("face_relation__the_common_line_lies_in_both_planes_and_parallel_planes_have_none") {
  Vec3 point, direction;
  const Plane a{normalized({1, 2, 3}), 4}, b{normalized({3, -1, 1}), -2};
  REQUIRE(common_line(a, b, {100, 200, 300}, point, direction));
  for (const double t : {-5.0, 0.0, 7.0}) {
    CHECK(std::fabs(a.distance(point + direction * t)) < 1e-12 * 300);
    CHECK(std::fabs(b.distance(point + direction * t)) < 1e-12 * 300);
  }
  CHECK(norm(direction) == doctest::Approx(1));
  CHECK(std::fabs(dot(point - Vec3{100, 200, 300}, direction)) <
        1e-9);  // the nearest of its points
  CHECK(!common_line(a, {a.normal, 9}, {}, point, direction));
}
