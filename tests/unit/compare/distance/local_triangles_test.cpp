// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/local_triangles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "geometry/delaunay2.h"
#include "spatial/triangles/closest.h"

using namespace jalon;

namespace {

// A patch of surface with noise, seen from the point of it that is nearest to a query.
struct Patch {
  std::vector<Vec3> points;
  std::vector<Vec3> queries;  ///< to all of which the origin is nearest
};

Patch patch(size_t n, double noise, uint64_t seed) {
  RandomStream random(seed, 0);
  const auto place = [&] {
    return Vec3{2 * random.uniform() - 1, 2 * random.uniform() - 1, noise * random.normal()};
  };
  Patch out;
  for (size_t i = 0; i < n; ++i) out.points.push_back(place());
  const Vec3 centre = out.points[random.below(n)];
  for (Vec3& p : out.points) p -= centre;
  while (out.queries.size() < 5) {
    const Vec3 q = place() * 1.1 - centre;
    const bool nearest =
        std::ranges::all_of(out.points, [&](const Vec3& p) { return norm(q) <= norm(q - p); });
    if (nearest) out.queries.push_back(q);
  }
  return out;
}

// Least distance from all triangles of the whole, or limit.
double slow_distance(const Patch& patch, const Vec3& query, double limit) {
  std::vector<Vec2> flat;
  for (const Vec3& p : patch.points) flat.push_back({p.x, p.y});
  const auto vector_of = [](const Vec3& p) { return Vector<double>{p.x, p.y, p.z}; };
  double least = limit * limit;
  for (const auto& t : delaunay(flat, 0x1p-24))
    least = std::min(
        least, closest_on_triangle(vector_of(query), vector_of(patch.points[t[0]]),
                                   vector_of(patch.points[t[1]]), vector_of(patch.points[t[2]]))
                   .squared);
  return std::sqrt(least);
}

constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0};

}  // namespace

TEST_CASE("local_triangles__give_the_distance_from_all_triangles_though_few_are_made") {
  size_t made = 0, all = 0;
  LocalTriangles reused;
  for (const double noise : {0.0, 0.05, 0.5})
    for (uint64_t seed = 1; seed <= 300; ++seed) {
      const size_t n = 3 + seed % 40;
      const Patch here = patch(n, noise, seed);
      REQUIRE(reused.set(here.points, {}, kX, kY));
      for (const Vec3& q : here.queries) {
        Vec3 foot, alone;
        const bool found = reused.foot(q, norm(q), foot);
        const double distance = found ? norm(q - foot) : norm(q),
                     slow = slow_distance(here, q, norm(q));
        REQUIRE(std::fabs(distance - slow) < 1e-12);
        // Whatever was asked for before.
        LocalTriangles fresh;
        REQUIRE(fresh.set(here.points, {}, kX, kY));
        REQUIRE(fresh.foot(q, norm(q), alone) == found);
        if (found) REQUIRE(alone == foot);
      }
      made += reused.made();
      all += 2 * n - 5;
    }
  MESSAGE("FIGURE local triangles: ", made, " made of about ", all);
  CHECK(made < all / 2);
}
