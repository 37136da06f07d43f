// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>

#include "solid/fcl_distance.h"
#include "unit/solid/brute_force.h"

#ifdef JALON_WITH_FCL

using namespace jalon;

namespace {

using Corners = std::array<Vec3, 3>;

const Corners kFlat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};

Corners moved(const Corners& c, const Vec3& by) { return {{c[0] + by, c[1] + by, c[2] + by}}; }

}  // namespace

TEST_CASE("triangle_distance__of_parallel_piercing_and_edge_to_edge_triangles") {
  Vec3 p, q;
  CHECK(triangle_distance(kFlat, moved(kFlat, {0, 0, 2}), p, q) == doctest::Approx(2));
  CHECK(norm(q - p - Vec3{0, 0, 2}) < 1e-12);
  const Corners upright{{{0.2, 0.2, -1}, {0.2, 0.2, 1}, {0.3, 0.3, 1}}};
  CHECK(triangle_distance(kFlat, upright, p, q) == 0);
  // The edge along x at y = 0 against one along z at y = -3.
  const Corners across{{{0.5, -3, -1}, {0.5, -3, 1}, {0.5, -4, 0}}};
  CHECK(triangle_distance(kFlat, across, p, q) == doctest::Approx(3));
  CHECK(norm(p - Vec3{0.5, 0, 0}) < 1e-9);
  CHECK(norm(q - Vec3{0.5, -3, 0}) < 1e-9);
}

TEST_CASE("triangle_distance__is_that_of_its_two_points_and_below_any_other_pair") {
  RandomStream random(21, 0);
  for (int i = 0; i < 100; ++i) {
    Corners a, b;
    for (Vec3& c : a) c = brute::any_vector(random, 1);
    for (Vec3& c : b) c = brute::any_vector(random, 1) + Vec3{2.5, 0, 0};
    Vec3 p, q;
    const double d = triangle_distance(a, b, p, q);
    CHECK(d == doctest::Approx(norm(p - q)).epsilon(1e-9));
    for (int k = 0; k < 50; ++k) {
      const double u = random.uniform(), v = (1 - u) * random.uniform();
      const double s = random.uniform(), t = (1 - s) * random.uniform();
      CHECK(d <= norm(a[0] * u + a[1] * v + a[2] * (1 - u - v) - b[0] * s - b[1] * t -
                      b[2] * (1 - s - t)) +
                     1e-9);
    }
  }
}

TEST_CASE("nearest_pair__of_two_soups_is_the_least_of_all_pairs") {
  require_fcl();
  RandomStream random(22, 0);
  for (int scene = 0; scene < 10; ++scene) {
    std::vector<Vec3> vertices[2];
    std::vector<std::array<uint32_t, 3>> triangles;
    for (uint32_t t = 0; t < 15; ++t) {
      for (int side = 0; side < 2; ++side) {
        const Vec3 at = brute::any_vector(random, 2) + Vec3{side * 5.0, 0, 0};
        for (int c = 0; c < 3; ++c) vertices[side].push_back(at + brute::any_vector(random, 0.3));
      }
      triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    Task task;
    const TriangleBoxes a(vertices[0], triangles, task), b(vertices[1], triangles, task);
    double least = 1e300;
    Vec3 p, q;
    for (uint32_t i = 0; i < 15; ++i)
      for (uint32_t j = 0; j < 15; ++j)
        least = std::min(least, triangle_distance(a.corners(i), b.corners(j), p, q));
    const TrianglePair pair = nearest_pair(a, b);
    CHECK(pair.distance_m == doctest::Approx(least).epsilon(1e-9));
    CHECK(triangle_distance(a.corners(pair.first), b.corners(pair.second), p, q) ==
          doctest::Approx(least).epsilon(1e-9));
  }
}

#endif
