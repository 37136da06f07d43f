// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Pieces that are gone through when they are asked for, against all connected components.
#include "spatial/voxels/voxel_flood.h"

#include <doctest/doctest.h>

#include <vector>

#include "base/random.h"
#include "spatial/voxels/components.h"

using namespace jalon;

namespace {

// Clumps about the origin and far from it, so that pieces cross blocks and negative voxels.
std::vector<Vec3> clumps(uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> out;
  for (int clump = 0; clump < 40; ++clump) {
    const Vec3 at{40 * random.uniform() - 20, 40 * random.uniform() - 20, 6 * random.uniform() - 3};
    for (int i = 0; i < 200; ++i)
      out.push_back(at + Vec3{random.normal(), random.normal(), random.normal()});
  }
  return out;
}

struct Flooded {
  VoxelFlood flood;
  std::vector<uint32_t> voxels;

  Flooded(const std::vector<Vec3>& points, double cell_m) : flood(cell_m) {
    for (const Vec3& p : points) voxels.push_back(flood.add(p));
  }
};

std::vector<uint32_t> labels_of(const std::vector<Vec3>& points, double cell_m) {
  std::vector<double> xyz;
  for (const Vec3& p : points) xyz.insert(xyz.end(), {p.x, p.y, p.z});
  Task task;
  return connected_components(xyz, {}, cell_m, Connectivity3::k26, 1, task).labels;
}

}  // namespace

TEST_CASE("voxel_flood__takes_the_connected_component_of_a_voxel_and_no_more") {
  for (const double cell_m : {0.3, 0.7}) {
    CAPTURE(cell_m);
    const auto points = clumps(7);
    const auto labels = labels_of(points, cell_m);
    for (const size_t start : {size_t{0}, size_t{1234}, points.size() - 1}) {
      Flooded f(points, cell_m);
      CHECK_FALSE(f.flood.has_new());
      f.flood.take(f.voxels[start]);
      CHECK(f.flood.has_new());
      size_t taken = 0;
      for (size_t i = 0; i < points.size(); ++i) {
        REQUIRE(f.flood.is_new(f.voxels[i]) == (labels[i] == labels[start]));
        taken += f.flood.is_new(f.voxels[i]) ? 1 : 0;
      }
      CHECK(taken > 0);
      CHECK(taken < points.size());
    }
  }
}

TEST_CASE("voxel_flood__tells_what_is_new_from_what_was_settled") {
  const std::vector<Vec3> points{{0, 0, 0}, {0.9, 0, 0}, {-0.5, -0.5, -0.5}, {5, 5, 5}};
  Flooded f(points, 1);
  f.flood.take(f.voxels[0]);
  CHECK(f.flood.is_new(f.voxels[2]));  // over a corner, into another block
  CHECK_FALSE(f.flood.is_settled(f.voxels[2]));
  f.flood.settle();
  CHECK_FALSE(f.flood.has_new());
  CHECK(f.flood.is_settled(f.voxels[1]));
  CHECK_FALSE(f.flood.is_settled(f.voxels[3]));
  f.flood.take(f.voxels[1]);  // of a piece that was taken
  CHECK_FALSE(f.flood.has_new());
  f.flood.take(f.voxels[3]);
  CHECK(f.flood.is_new(f.voxels[3]));
  CHECK_FALSE(f.flood.is_new(f.voxels[0]));
}
