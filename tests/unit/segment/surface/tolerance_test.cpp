// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/tolerance.h"

#include <doctest/doctest.h>

#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

CloudPtr noisy_wall(double sigma_m, double unit_m = 1) {
  Scene scene;
  RandomStream random(1, 7);
  scene.rectangle(1, {0, 0, 0}, {4 / unit_m, 0, 0}, {0, 0, 3 / unit_m}, 8000, sigma_m / unit_m,
                  random);
  return cloud_of(scene.points);
}

}  // namespace

TEST_CASE("tolerance_of_sigma__quantiles_of_one_and_two_degrees_of_freedom") {
  CHECK(tolerance_of_sigma(0.01, 0.9973002, 1) == doctest::Approx(0.03).epsilon(1e-4).scale(0));
  CHECK(tolerance_of_sigma(0.01, 0.6826895, 1) == doctest::Approx(0.01).epsilon(1e-4).scale(0));
  for (const double p : {0.5, 0.95, 0.99})  // of two: 1 - exp(-x / 2)
    CHECK(tolerance_of_sigma(0.01, p, 2) ==
          doctest::Approx(0.01 * std::sqrt(-2 * std::log(1 - p))).scale(0));
}

TEST_CASE("estimate_sigma__finds_the_noise_of_a_wall") {
  for (const double sigma_m : {0.002, 0.008}) {
    const auto cloud = noisy_wall(sigma_m);
    Task task;
    CHECK(estimate_sigma(*cloud, *cloud->octree(task), task) ==
          doctest::Approx(sigma_m).epsilon(0.05).scale(0));
  }
  Task task;
  const auto exact = noisy_wall(0);
  CHECK(estimate_sigma(*exact, *exact->octree(task), task) < 1e-6);
}

TEST_CASE("tolerance_of__by_hand_by_sigma_or_by_the_cloud") {
  const auto cloud = noisy_wall(0.004);
  Task task;
  const auto tree = cloud->octree(task);
  RansacSettings settings;
  settings.surface.distance_tolerance_m = 0.07;
  settings.tolerance.sigma_m = 0.002;
  CHECK(tolerance_of(*cloud, *tree, settings, task).distance_tolerance_m == 0.07);
  settings.tolerance.tolerance_from = ToleranceSource::kSigma;
  CHECK(tolerance_of(*cloud, *tree, settings, task).distance_tolerance_m ==
        doctest::Approx(0.002 * 2.575829).scale(0));
  settings.tolerance.tolerance_from = ToleranceSource::kEstimate;
  const Tolerance found = tolerance_of(*cloud, *tree, settings, task);
  CHECK(found.sigma_m == doctest::Approx(0.004).epsilon(0.05).scale(0));
  CHECK(found.distance_tolerance_m == doctest::Approx(2.575829 * found.sigma_m).scale(0));
}

TEST_CASE("tolerance_of__auto_is_the_default_on_an_exact_scan_and_wider_on_a_noisy_one") {
  RansacSettings settings;
  Task task;
  const auto tolerance = [&](double sigma_m) {
    const auto cloud = noisy_wall(sigma_m);
    return tolerance_of(*cloud, *cloud->octree(task), settings, task);
  };
  const double least = settings.surface.distance_tolerance_m;
  CHECK(tolerance(0.003).distance_tolerance_m == least);
  const Tolerance wide = tolerance(0.03);
  CHECK(wide.sigma_m == doctest::Approx(0.03).epsilon(0.1).scale(0));
  CHECK(wide.distance_tolerance_m == 3 * wide.sigma_m);
  // What was set stays, and so does the default where it is meant.
  settings.surface.distance_tolerance_m = 0.02;
  CHECK(tolerance(0.03).distance_tolerance_m == 0.02);
  settings.surface.distance_tolerance_m = least;
  settings.tolerance.tolerance_from = ToleranceSource::kHand;
  CHECK(tolerance(0.03).distance_tolerance_m == least);
}

TEST_CASE("tolerance_of__auto_takes_a_scan_in_millimetres_for_no_noisy_one_in_metres") {
  const auto cloud = noisy_wall(0.003, 0.001);
  Task task;
  const RansacSettings settings;
  CHECK(tolerance_of(*cloud, *cloud->octree(task), settings, task).distance_tolerance_m ==
        settings.surface.distance_tolerance_m);
}
