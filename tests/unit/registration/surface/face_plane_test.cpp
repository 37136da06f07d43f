// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Points of one face among neighbours that lie around an edge, against the faces that are known.

#include <doctest/doctest.h>

#include <cmath>

#include "geometry/plane.h"
#include "registration/surface/face_plane.h"
#include "unit/registration/icp_problems.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kFacePlaneNoise_m = 0.001, kStep_m = 0.05;

// A tree over points; the noise in its steps.
struct Faces {
  Cloud cloud;
  std::shared_ptr<const Octree> tree;

  explicit Faces(const std::vector<Vec3>& points) : cloud(cloud_of(points)) {
    Task task;
    tree = cloud.octree(task);
  }
  std::optional<PlanePoints> at(uint32_t index, uint32_t k = 32) const {
    const uint32_t position = position_in(*tree, index);
    const auto near = positions_near(*tree, position, k);
    return points_of_face(*tree, position, near, kFacePlaneNoise_m / tree->grid_step());
  }
};

std::vector<Vec3> floor_points(int n, double noise_m = kFacePlaneNoise_m) {
  RandomStream random(61, 0);
  return noisy_sheet({0.02, 0, 0}, {kStep_m, 0, 0}, {0, kStep_m, 0}, n, n, noise_m, random);
}

Vec3 normal_of(const Symmetric3& scatter) { return symmetric_eigen(scatter).vectors[0]; }

}  // namespace

TEST_CASE("points_of_face__near_an_edge_are_those_of_the_points_own_face") {
  std::vector<Vec3> points = floor_points(14);
  RandomStream random(62, 0);
  const auto wall = noisy_sheet({0, 0, 0.02}, {0, kStep_m, 0}, {0, 0, kStep_m}, 14, 14,
                                kFacePlaneNoise_m, random);
  const size_t of_floor = points.size();
  points.insert(points.end(), wall.begin(), wall.end());
  const Faces faces(points);
  size_t asked = 0, found = 0;
  for (uint32_t i = 0; i < of_floor; ++i) {
    if (points[i].x > 0.09) continue;
    ++asked;
    Moments all;
    const uint32_t position = position_in(*faces.tree, i);
    for (const uint32_t p : positions_near(*faces.tree, position, 32))
      all.add(faces.tree->local(p));
    CHECK(std::abs(normal_of(all.covariance()).z) < 0.99);  // around the corner it is slanted
    const auto face = faces.at(i);
    if (!face) continue;
    ++found;
    CHECK(face->count >= 6);
    // Three noises at the far side of a face a few steps wide.
    CHECK(std::abs(normal_of(face->scatter).z) > std::cos(3 * kFacePlaneNoise_m / kStep_m));
  }
  CHECK(asked >= 14);
  CHECK(static_cast<double>(found) >= 0.9 * static_cast<double>(asked));
}

TEST_CASE("points_of_face__of_a_sheet_are_all_neighbours_but_those_above_it") {
  std::vector<Vec3> points = floor_points(9, 0);
  const uint32_t middle = 40;
  points.push_back(points[middle] + Vec3{0.01, 0.02, 12 * kFacePlaneNoise_m});
  points.push_back(points[middle] + Vec3{-0.02, 0.01, -9 * kFacePlaneNoise_m});
  const Faces faces(points);
  const auto face = faces.at(middle);
  REQUIRE(face);
  CHECK(face->count == 30);
  const uint32_t position = position_in(*faces.tree, middle);
  Vec3 mean;
  for (const uint32_t p : positions_near(*faces.tree, position, 32))
    if (std::abs(faces.tree->local(p).z - faces.tree->local(position).z) < kFacePlaneNoise_m)
      mean += (faces.tree->local(p) - faces.tree->local(position)) / 30;
  // Neighbours come as floats of some 2^24 steps at the most.
  CHECK(norm(face->offset * faces.tree->grid_step() - mean) < 1e-6);
  CHECK(std::abs(normal_of(face->scatter).z) > 1 - 1e-9);
}

TEST_CASE("points_of_face__need_six_points_of_a_surface_that_are_no_line") {
  const std::vector<Vec3> sheet = floor_points(9);
  CHECK(Faces(sheet).at(40, 6));
  CHECK_FALSE(Faces(sheet).at(40, 5));
  std::vector<Vec3> line;
  for (int i = 0; i < 30; ++i) line.push_back({0.05 * i, 0.02 * i, 0.01 * i});
  CHECK_FALSE(Faces(line).at(15));
  // Of 32 points in a cube of a metre a plane has three, and half of one more within its four noises.
  for (uint32_t i = 0; i < 10; ++i) CHECK_FALSE(Faces(random_points(60, 1, 5)).at(i));
}
