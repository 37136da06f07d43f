// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Shares of points in the plane of one of them: what least squares gives back of functions it fits.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/surface/plane_points.h"
#include "registration/surface/quadric_plane.h"
#include "unit/registration/icp_problems.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr uint32_t kOfPlane = 16;

struct Planes {
  Cloud cloud;
  SurfacePlanes planes;

  explicit Planes(const std::vector<Vec3>& points) : cloud(cloud_of(points)) {
    Task task;
    planes = surface_planes(cloud.octree(task), kOfPlane, task);
  }
  uint32_t index(uint32_t position) const { return planes.tree->order()[position]; }
};

std::vector<Vec3> slanted_sheet(int n, double noise_m) {
  RandomStream random(101, 0);
  return noisy_sheet({}, {0.1, 0, 0.02}, {0, 0.1, 0.03}, n, n, noise_m, random);
}

}  // namespace

TEST_CASE("plane_shares__give_every_linear_function_back_and_the_height_of_the_plane") {
  const Planes sheet(slanted_sheet(9, 0.004));
  for (uint32_t p = 0; p < sheet.planes.size(); p += 5) {
    const SurfacePlane& plane = sheet.planes.planes[p];
    if (plane.shape != SurfaceShape::kPlane) continue;
    const auto shares = plane_shares(sheet.planes, p, kOfPlane);
    REQUIRE(shares.size() == kOfPlane);
    CHECK(shares[0].position == p);
    const Vec3 n = plane.unit(), along = normalized(cross(n, {1, 2, 3}));
    double ones = 0, linear = 0, height = 0;
    Vec3 slope_ones, slope_linear;
    for (const PlaneShare& share : shares) {
      const Vec3 d = sheet.planes.place(share.position) - sheet.planes.place(p);
      ones += share.height;
      linear += share.height * dot(along, d);
      height += share.height * dot(n, d);
      slope_ones += share.slope;
      slope_linear += share.slope * dot(along, d);
    }
    // Normals are kept as floats.
    CHECK(ones == doctest::Approx(1).epsilon(1e-9));
    CHECK(std::abs(linear) < 1e-7);
    CHECK(height == doctest::Approx(double{plane.height_m}).scale(0.01).epsilon(1e-5));
    CHECK(norm(slope_ones) < 1e-9);
    CHECK(norm(slope_linear - along) < 1e-5);
  }
}

TEST_CASE("plane_shares__of_a_paraboloid_give_its_six_terms_back") {
  std::vector<Vec3> ball = sphere(300, 0.4);
  Planes bent(ball);
  const uint32_t p = position_in(*bent.planes.tree, 120);
  bent.planes.planes[p].shape = SurfaceShape::kQuadric;
  const auto near = positions_near(*bent.planes.tree, p, kOfPlane);
  const auto quadric = local_quadric(*bent.planes.tree, p, near);
  REQUIRE(quadric);
  const auto shares = plane_shares(bent.planes, p, kOfPlane);
  REQUIRE(shares.size() == kOfPlane);
  Coefficients<6> heights{};
  Vec3 slopes[6];
  for (const PlaneShare& share : shares) {
    const auto terms = quadric->terms(bent.planes.place(share.position) - bent.planes.place(p));
    for (size_t k = 0; k < 6; ++k) {
      heights[k] += share.height * terms[k];
      slopes[k] += share.slope * terms[k];
    }
  }
  for (size_t k = 0; k < 6; ++k) {
    CHECK(std::abs(heights[k] - (k == 0 ? 1 : 0)) < 1e-9);
    const Vec3 expected = k == 1   ? quadric->u / quadric->scale_m
                          : k == 2 ? quadric->v / quadric->scale_m
                                   : Vec3{};
    CHECK(norm(slopes[k] - expected) < 1e-8);
  }
}

TEST_CASE("plane_shares__of_a_face_are_of_its_own_points_and_of_no_plane_none") {
  RandomStream random(102, 0);
  std::vector<Vec3> points =
      noisy_sheet({0.02, 0, 0}, {0.05, 0, 0}, {0, 0.05, 0}, 16, 16, 0.001, random);
  const auto of_floor = static_cast<uint32_t>(points.size());
  const auto wall = noisy_sheet({0, 0, 0.02}, {0, 0.05, 0}, {0, 0, 0.05}, 16, 16, 0.001, random);
  points.insert(points.end(), wall.begin(), wall.end());
  const Planes edge(points);
  size_t faces = 0;
  for (uint32_t p = 0; p < edge.planes.size(); ++p) {
    const SurfacePlane& plane = edge.planes.planes[p];
    // Those whose face was told right: by its normal.
    const bool on_floor = edge.index(p) < of_floor;
    if (plane.shape != SurfaceShape::kFace || !edge.planes.flat(p)) continue;
    if (std::abs(on_floor ? plane.unit().z : plane.unit().x) < 0.995) continue;
    ++faces;
    double ones = 0;
    const auto shares = plane_shares(edge.planes, p, kOfPlane);
    CHECK(shares.size() < kOfPlane);
    for (const PlaneShare& share : shares) {
      ones += share.height;
      const Vec3 place = points[edge.index(share.position)];
      CHECK(std::abs(on_floor ? place.z : place.x) < 0.02);  // the wall begins there
    }
    CHECK(ones == doctest::Approx(1).epsilon(1e-9));
  }
  CHECK(faces > 5);
  std::vector<Vec3> line;
  for (int i = 0; i < 30; ++i) line.push_back({0.25 * i, 0, 0});
  const Planes thin(line);
  CHECK(plane_shares(thin.planes, 10, kOfPlane).empty());
}
