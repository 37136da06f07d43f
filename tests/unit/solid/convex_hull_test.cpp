// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "solid/convex_hull.h"

#include <doctest/doctest.h>

#include "unit/solid/bodies.h"
#include "unit/solid/status.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// By the divergence theorem: a third of the sum of offset times area.
double volume_of(const ConvexHull& hull) {
  double sum = 0;
  for (const ConvexHull::Facet& f : hull.facets) {
    const Vec3 a = hull.corners[f.corners[0]], b = hull.corners[f.corners[1]],
               c = hull.corners[f.corners[2]];
    sum += f.offset * norm(cross(b - a, c - a)) / 6;
  }
  return sum;
}

}  // namespace

TEST_CASE("convex_hull__of_a_box_has_its_eight_corners_its_volume_and_unit_normals_outward") {
  std::vector<Vec3> points = box_corners({2, 3, 4});
  for (Vec3& p : points) p += Vec3{10, -20, 30};
  points.push_back({10, -20, 30});
  points.push_back({11, -20, 30});  // on a side
  points.push_back(points[0]);      // twice
  const ConvexHull hull = convex_hull(points);
  CHECK(hull.corners.size() == 8);
  CHECK(hull.facets.size() == 12);  // Euler: 2 V - 4
  CHECK(volume_of(hull) == doctest::Approx(24).epsilon(1e-9));
  for (const ConvexHull::Facet& f : hull.facets) {
    CHECK(norm(f.normal) == doctest::Approx(1).epsilon(1e-12));
    CHECK(dot(f.normal, Vec3{10, -20, 30}) < f.offset);
    for (const uint32_t c : f.corners)
      CHECK(dot(f.normal, hull.corners[c]) == doctest::Approx(f.offset).scale(0).epsilon(1e-9));
  }
}

TEST_CASE("convex_hull__of_any_points_lies_outside_none_and_does_not_depend_on_their_order") {
  RandomStream random(3, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < 60; ++i) points.push_back(brute::any_vector(random, 2));
  const ConvexHull hull = convex_hull(points);
  for (const ConvexHull::Facet& f : hull.facets)
    for (const Vec3& p : points) CHECK(dot(f.normal, p) <= f.offset + 1e-9);
  std::reverse(points.begin(), points.end());
  const ConvexHull back = convex_hull(points);
  CHECK(back.corners.size() == hull.corners.size());
  CHECK(volume_of(back) == doctest::Approx(volume_of(hull)).scale(0).epsilon(1e-9));
}

TEST_CASE("convex_hull__refuses_three_points_flat_ones_and_too_many") {
  const std::vector<Vec3> three{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(status_of([&] { convex_hull(three); }) == Status::kInsufficientData);
  const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}, {2, 2, 4}};
  CHECK(status_of([&] { convex_hull(flat); }) == Status::kDegenerate);
  CHECK(status_of([&] { convex_hull(std::vector<Vec3>(kMaxHullPoints + 1)); }) == Status::kLimit);
}

TEST_CASE("convex_hull__refuses_points_of_any_oblique_plane_wherever_and_takes_a_thin_sheet") {
  const std::vector<Vec3> oblique{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2}, {2, 1, 3}};
  CHECK(status_of([&] { convex_hull(oblique); }) == Status::kDegenerate);
  RandomStream random(3, 2);
  for (int draw = 0; draw < 300; ++draw) {
    const double size_m = std::pow(10, 4 * random.uniform() - 2);
    const Vec3 at =
        draw % 2 == 0 ? Vec3{} : Vec3{652000, 6861000, 35} + brute::any_vector(random, 10);
    const Vec3 u = normalized(brute::any_vector(random, 1)),
               n = normalized(cross(u, brute::any_vector(random, 1))), v = cross(n, u);
    const double narrow = draw % 3 == 0 ? 1e-3 : 1;
    std::vector<Vec3> points;
    for (int i = 0; i < 20; ++i) {
      const double a = random.uniform(), b = narrow * random.uniform();
      points.push_back(at + size_m * (a * u + b * v));
    }
    CAPTURE(draw);
    CHECK(status_of([&] { convex_hull(points); }) == Status::kDegenerate);
    // A micrometre for a metre, and no less than 0.1 um at seven digits.
    points.push_back(at + size_m * (0.4 * u + narrow * 0.5 * v) +
                     std::max(1e-6 * size_m, 1e-7) * n);
    CHECK(convex_hull(points).facets.size() >= 4);
  }
  std::vector<Vec3> line;
  for (int i = 0; i < 9; ++i) line.push_back({0.1 * i, 0.3 * i, 0.7 * i});
  CHECK(status_of([&] { convex_hull(line); }) == Status::kDegenerate);
  CHECK(status_of([&] { convex_hull(std::vector<Vec3>(5, {1, 2, 3})); }) == Status::kDegenerate);
}
