// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The nearest of very many triangles on one another, for very many points on one place.
#include <doctest/doctest.h>

#include <limits>
#include <numeric>
#include <vector>

#include "base/random.h"
#include "base/task.h"
#include "spatial/triangles/nearest.h"
#include "unit/spatial/triangles/mesh.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("triangle_nearest__of_thousands_of_triangles_on_one_another_gives_the_least_number") {
  // Others first; then equal ones and some a whisker smaller, one of which gets a low number.
  Mesh mesh;
  RandomStream random(9, 0);
  for (int i = 0; i < 500; ++i) {
    const double x = 10 * random.uniform(), y = 10 * random.uniform(), z = 10 * random.uniform();
    mesh.add({x, y, z}, {x + 0.5, y, z}, {x, y + 0.5, z});
  }
  const Vec3 a{20, 20, 20}, b{21, 20, 20}, c{20, 21, 20};
  for (int i = 0; i < 3000; ++i) {
    const double less = i % 3 == 0 ? 0 : 0x1p-30 * static_cast<double>(random.below(1000));
    mesh.add(a, b - Vec3{less, 0, 0}, c - Vec3{0, less, 0});
  }
  std::swap(mesh.triangles[7], mesh.triangles[500]);
  const auto tree = built<NearestTriangles>(mesh, 2);
  constexpr size_t kEach = 300;
  std::vector<double> xyz;
  std::vector<Vec3> points;
  for (const Vec3& p : {a, a + Vec3{0.25, 0.25, 0}, a + Vec3{0.25, 0.5, 0}, a + Vec3{0, 0, 3},
                        b + Vec3{1, 0, 0}, c})
    points.insert(points.end(), kEach, p);
  for (const Vec3& p : points) xyz.insert(xyz.end(), {p.x, p.y, p.z});
  std::vector<uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<TriangleAnswer> found(points.size());
  Task task;
  tree->for_each(xyz, order, std::numeric_limits<double>::infinity(), {true, true}, task,
                 [&](uint32_t i, const TriangleAnswer& answer) { found[i] = answer; });
  for (size_t i = 0; i < points.size(); ++i) {
    CHECK(found[i].triangle == 7);
    const TriangleAnswer alone = tree->nearest(points[i]);
    CHECK(alone.triangle == 7);
    CHECK(found[i].distance == alone.distance);
    CHECK(found[i].is_behind == alone.is_behind);
    CHECK(found[i].side == alone.side);
    CHECK(found[i].foot == alone.foot);
  }
  CHECK(found[0].distance == 0);
  CHECK(found[3 * kEach].distance == 3);
}
