// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Local models applied to distances that are given: which are replaced, by what, and that all else stays.
#include "compare/distance/local_models.h"

#include <doctest/doctest.h>

#include "unit/compare/distance_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Distances to the nearest points by brute force, and what the local models make of them.
struct Modelled {
  CloudPtr reference, other;
  DistanceColumns columns;
  std::vector<double> plain;
  uint64_t count = 0;

  // without: so many of the first compared points have no nearest point.
  Modelled(const std::vector<double>& a, const std::vector<double>& b,
           const DistanceSettings& settings, size_t without = 0)
      : reference(cloud_of(a)), other(cloud_of(b)), columns(other->size(), true) {
    Task task;
    const auto tree = reference->octree(task), queries = other->octree(task);
    std::vector<uint32_t> nearest(other->size(), kNoPoint);
    plain.assign(other->size(), -1);
    for (size_t q = 0; q < other->size(); ++q) {
      const size_t i = queries->order()[q];
      columns.distances[i] = -1;
      columns.set_difference(i, {9, 9, 9});
      if (i < without) continue;
      double least = INFINITY;
      for (uint32_t p = 0; p < reference->size(); ++p) {
        const double d2 = squared_norm(reference->point(tree->order()[p]) - other->point(i));
        if (d2 < least) least = d2, nearest[q] = p;
      }
      columns.distances[i] = plain[i] = std::sqrt(least);
    }
    count = apply_local_models(*tree, *queries, *other, nearest, settings, columns, task);
  }
  Modelled(const Modelled&) = delete;
  Modelled& operator=(const Modelled&) = delete;
};

// Plane z = 0.75 y: a lattice of 0.125 m about the origin.
std::vector<double> slope() {
  std::vector<double> xyz;
  for (int i = -16; i <= 16; ++i)
    for (int j = -16; j <= 16; ++j) {
      const double x = 0.125 * i, y = 0.125 * j;
      xyz.insert(xyz.end(), {x, y, 0.75 * y});
    }
  return xyz;
}

}  // namespace

TEST_CASE("local_models__give_distance_and_foot_on_a_plane_from_around_either_point") {
  // A point at (x, y) this far above the slope across, over the middle of a cell.
  const Vec3 normal{0, -0.6, 0.8};
  std::vector<double> above;
  for (int i = 0; i < 20; ++i) {
    const Vec3 p = Vec3{0.0625 + 0.05 * i, 0.3, 0.225} + normal * 0.02;
    above.insert(above.end(), {p.x, p.y, p.z});
  }
  for (const auto where :
       {DistanceSettings::Neighbourhood::kNearest, DistanceSettings::Neighbourhood::kPoint})
    for (const double radius_m : {0.0, 0.3}) {
      DistanceSettings settings;
      settings.local_model = LocalModelKind::kPlane;
      settings.neighbourhood = where;
      settings.radius_m = radius_m;
      const Modelled made(slope(), above, settings);
      for (size_t i = 0; i < 20; ++i) {
        // The grid of the reference's tree has a step of its cube / 2^31, some 1e-9 m.
        REQUIRE(made.columns.distances[i] == doctest::Approx(0.02).epsilon(1e-7).scale(1));
        const Vec3 d{made.columns.differences[0][i], made.columns.differences[1][i],
                     made.columns.differences[2][i]};
        REQUIRE(norm(d - normal * 0.02) < 1e-7);
      }
      CHECK(made.count == 20);
    }
}

TEST_CASE("local_models__count_what_they_replace_and_leave_the_rest_as_it_was") {
  // Above the slope, on points of it (no surface is nearer than 0), and far beyond its end.
  std::vector<double> points = {0.0625, 0.0625, 0.25, 0.25, 0.25, 0.1875, 9, 0, 0, 0.3, 0.3, 0.5};
  for (const LocalModelKind kind :
       {LocalModelKind::kPlane, LocalModelKind::kDelaunay, LocalModelKind::kQuadric}) {
    DistanceSettings settings;
    settings.local_model = kind;
    const Modelled made(slope(), points, settings, 1);
    CHECK(made.columns.distances[0] == -1);  // it has no nearest point
    CHECK(made.columns.differences[0][0] == 9);
    CHECK(made.columns.distances[1] == 0);
    CHECK(made.columns.distances[2] == made.plain[2]);
    CHECK(made.columns.differences[0][2] == 9);
    CHECK(made.columns.distances[3] < made.plain[3]);
    CHECK(made.columns.distances[3] == doctest::Approx((0.5 - 0.225) * 0.8).epsilon(1e-7).scale(0));
    CHECK(made.count == 1);
  }
}
