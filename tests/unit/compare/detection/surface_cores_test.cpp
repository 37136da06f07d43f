// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/surface_cores.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("surface_cores__know_the_noise_and_the_plane_of_a_sheet") {
  Task task;
  RandomStream random(8, 8);
  std::vector<Vec3> points;
  for (int k = 0; k < 20000; ++k)
    points.push_back({4 * random.uniform(), 4 * random.uniform(), 0.003 * random.normal()});
  const SurfaceCores cores(cloud_of(points), {}, task);
  CHECK(cores.size() == 1250);
  CHECK(cores.noise_m() == doctest::Approx(0.003).epsilon(0.15).scale(0));
  for (size_t k = 0; k < cores.size(); ++k) {
    REQUIRE(cores[k].has_plane());
    CHECK(std::abs(cores[k].normal.z) > 0.99);
    // In the middle the plane is known to its scatter over the root of its points, aside less well.
    const double middle = cores[k].variance_at(cores[k].centroid);
    CHECK(middle == doctest::Approx(cores[k].sigma_m * cores[k].sigma_m / cores[k].count));
    CHECK(cores[k].variance_at(cores[k].centroid + cores[k].axis_v * cores[k].radius_m) >
          2 * middle);
  }
}

TEST_CASE("surface_cores__a_row_with_one_point_beside_it_has_no_plane") {
  Task task;
  RandomStream random(9, 8);
  std::vector<Vec3> points;
  for (int k = 0; k < 100; ++k) points.push_back({0.03 * k, 0.001 * random.normal(), 0});
  const Vec3 beside{1.5, 0.3, -0.04};  // on the wall below the edge that the row runs along
  points.push_back(beside);
  const SurfaceCores cores(cloud_of(points), {}, task);
  size_t with_it = 0;
  for (size_t k = 0; k < cores.size(); ++k) {
    if (std::abs(cores[k].centroid.x - beside.x) > 0.3) continue;
    ++with_it;
    CHECK_FALSE(cores[k].has_plane());
  }
  CHECK(with_it > 0);
}

TEST_CASE("surface_cores__points_on_a_line_have_no_plane") {
  Task task;
  std::vector<Vec3> points;
  for (int k = 0; k < 100; ++k) points.push_back({0.01 * k, 0, 0});
  const SurfaceCores cores(cloud_of(points), {}, task);
  for (size_t k = 0; k < cores.size(); ++k) CHECK_FALSE(cores[k].has_plane());
  CHECK(cores.noise_m() == 0);
}
