// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/surface_noise.h"

#include <doctest/doctest.h>

#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double noise_of(const Scene& scene) {
  const CloudPtr cloud = cloud_of(scene.points);
  Task task;
  return surface_noise_m(*cloud, *cloud->octree(task), task);
}

}  // namespace

TEST_CASE("surface_noise_m__finds_the_noise_of_a_wall_whatever_the_spacing") {
  for (const double sigma_m : {0.002, 0.01, 0.03, 0.06}) {
    CAPTURE(sigma_m);
    Scene scene;
    RandomStream random(3, 7);
    scene.rectangle(1, {0, 0, 0}, {8, 0, 0}, {0, 0, 6}, 40000, sigma_m, random);
    CHECK(noise_of(scene) == doctest::Approx(sigma_m).epsilon(0.1).scale(0));
  }
}

TEST_CASE("surface_noise_m__is_that_of_the_noisier_kind_of_surfaces") {
  Scene scene;
  RandomStream random(4, 7);
  scene.rectangle(1, {0, 0, 0}, {8, 0, 0}, {0, 0, 4}, 12000, 0.02, random);
  scene.rectangle(2, {0, 0, 0}, {8, 0, 0}, {0, -6, 0}, 30000, 0.002, random);
  CHECK(noise_of(scene) == doctest::Approx(0.02).epsilon(0.1).scale(0));
}

TEST_CASE("surface_noise_m__shape_is_no_noise_and_a_volume_has_none") {
  // Two thirds of a wall are battens 5 cm deep, narrower than the neighbourhoods.
  Scene battens;
  RandomStream random(5, 7);
  battens.rectangle(1, {0, 0, 0}, {3, 0, 0}, {0, 0, 3}, 9000, 0.002, random);
  for (int i = 0; i < 60; ++i)
    battens.rectangle(2 + i, {3 + 0.1 * i, i % 2 * 0.05, 0}, {0.1, 0, 0}, {0, 0, 3}, 300, 0.002,
                      random);
  CHECK(noise_of(battens) < 0.003);
  Scene volume;
  for (int i = 0; i < 20000; ++i)
    volume.points.push_back({4 * random.uniform(), 4 * random.uniform(), 4 * random.uniform()});
  CHECK(noise_of(volume) == 0);
}

TEST_CASE("surface_noise_m__posts_and_bays_of_a_coarse_scan_are_shape") {
  // Bays 1.2 m wide between posts 0.3 m before them, points 0.15 m apart: wide neighbourhoods hold both.
  for (const double sigma_m : {0.0075, 0.02}) {
    CAPTURE(sigma_m);
    Scene scene;
    RandomStream random(8, 7);
    for (int i = 0; i < 40; ++i)
      for (int k = 0; k < 12; ++k) {
        const double x = 1.6 * i, z = 1.6 * k;
        const double deep = (i + k) % 3 * 0.1;
        scene.rectangle(1, {x, deep, z}, {1.2, 0, 0}, {0, 0, 1.2}, 64, sigma_m, random);
        scene.rectangle(2, {x + 1.2, -0.3, z}, {0.4, 0, 0}, {0, 0, 1.6}, 28, sigma_m, random);
        scene.rectangle(3, {x, -0.2, z + 1.2}, {1.2, 0, 0}, {0, 0, 0.4}, 21, sigma_m, random);
      }
    CHECK(noise_of(scene) == doctest::Approx(sigma_m).epsilon(0.25).scale(0));
  }
}

TEST_CASE("surface_noise_m__a_profile_alone_is_no_surface") {
  // Upright profiles 0.1 m apart, noise along the beams. On one metre of fourteen a point every 3 mm: the neighbours
  // there are of one profile, and thin across the wall.
  constexpr double kNoise_m = 0.03;
  Scene scene;
  RandomStream random(9, 7);
  for (int profile = 0; profile < 140; ++profile) {
    const bool is_dense = profile / 10 % 14 == 3;
    for (double z = 0; z < 6; z += is_dense ? 0.003 : 0.01)
      scene.points.push_back(
          {0.1 * profile + 0.001 * random.normal(), kNoise_m * random.normal(), z});
  }
  CHECK(noise_of(scene) == doctest::Approx(kNoise_m).epsilon(0.15).scale(0));
}

TEST_CASE("surface_noise_m__few_points_and_flat_ones") {
  Scene scene;
  RandomStream random(6, 7);
  scene.rectangle(1, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 20, 0, random);
  CHECK(noise_of(scene) < 1e-6);
}
