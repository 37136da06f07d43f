// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/triangles/stacks.h"

#include <doctest/doctest.h>

#include <numeric>

#include "base/random.h"
#include "spatial/triangles/nearest.h"
#include "unit/spatial/triangles/mesh.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Of a mesh of some metres.
constexpr double kCell_m = 0x1p-44;
constexpr Vec3 kA{0.1, 0.2, 0.3}, kB{1.1, 0.2, 0.3}, kC{0.1, 1.2, 0.3};

TriangleStacks stacks_of(const Mesh& mesh) {
  Task task;
  return triangle_stacks(mesh.vertices, mesh.triangles, {}, kCell_m, task);
}

// A roof whose two slopes are stacks, a whisker apart within each; its ridge along y.
Mesh roof_of(size_t layers) {
  const Vec3 front{0, 0, 3}, back{0, 4, 3}, left{-3, 2, 0}, right{3, 2, 0};
  Mesh mesh;
  RandomStream random(3, 0);
  for (size_t i = 0; i < layers; ++i) {
    const Vec3 less{0, 0, 0x1p-52 * random.uniform()};
    mesh.add(left - less, front, back - less);
    mesh.add(right, back - less, front);
  }
  return mesh;
}

}  // namespace

TEST_CASE("triangle_stacks__one_stands_for_those_that_run_its_way_and_the_other_way") {
  Mesh mesh;
  mesh.add(kA, kB, kC + Vec3{0, 1, 0});
  for (int i = 0; i < 20; ++i) mesh.add(kA, kB, kC);
  for (int i = 0; i < 7; ++i) mesh.add(kB, kA, kC);
  mesh.add(kC, kA, kB);  // the same way around, from another corner
  const TriangleStacks found = stacks_of(mesh);
  REQUIRE(found.distinct == std::vector<uint32_t>{0, 1});
  CHECK(found.stacks[0].alike == 1);
  CHECK(found.stacks[0].reversed == 0);
  CHECK(found.stacks[1].alike == 21);
  CHECK(found.stacks[1].reversed == 7);
}

TEST_CASE("triangle_stacks__low_ones_and_triangles_of_a_cell_stay_as_they_are") {
  Mesh mesh;
  for (size_t i = 0; i + 1 < kHighStack; ++i) mesh.add(kA, kB, kC);
  const Vec3 tiny{kCell_m / 8, 0, 0};
  for (int i = 0; i < 100; ++i) mesh.add(kA, kA + tiny, kA + tiny);
  const TriangleStacks found = stacks_of(mesh);
  std::vector<uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  CHECK(found.distinct == all);
  for (const TriangleStack& stack : found.stacks) CHECK(stack.alike == 1);
}

TEST_CASE("triangle_nearest__of_stacks_tells_sides_by_few_triangles_as_one_layer_does") {
  constexpr size_t kLayers = 3001;  // odd, as one layer
  const auto high = built<NearestTriangles>(roof_of(kLayers)),
             one = built<NearestTriangles>(roof_of(1));
  CHECK(high->size() == 2 * kLayers);
  CHECK(high->distinct() <= 2 * 64);  // corners on the border of a cell part a stack
  CHECK(one->distinct() == 2);
  RandomStream random(4, 0);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p{8 * random.uniform() - 4, 6 * random.uniform() - 1, 5 * random.uniform()};
    const TriangleAnswer a = high->nearest(p), b = one->nearest(p);
    CHECK(a.is_behind == b.is_behind);
    CHECK(a.side == b.side);
  }
}
