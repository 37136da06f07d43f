// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/statistics.h"

#include <doctest/doctest.h>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

TEST_CASE("covariance__of_a_known_set__is_exact") {
  Task task;
  const CloudCovariance whole =
      covariance_of(cloud_of({{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {2, 4, 6}}), task);
  CHECK(whole.centroid == Vec3{1, 2, 1.5});
  CHECK(whole.covariance == Symmetric3{1, 0, 1.5, 4, 3, 6.75});
}

TEST_CASE("covariance__uniform_box__is_size_squared_over_12_and_the_same_on_the_map_grid") {
  const auto points = random_points(200000, 12, 41);
  Task one(threads(1)), seven(threads(7));
  const CloudCovariance near = covariance_of(cloud_of(points), one),
                        far = covariance_of(cloud_of(shifted(points, kFar)), seven);
  for (const size_t i : {size_t{0}, size_t{3}, size_t{5}})
    CHECK(near.covariance[i] == doctest::Approx(12).epsilon(0.01));
  for (const size_t i : {size_t{1}, size_t{2}, size_t{4}})
    CHECK(std::fabs(near.covariance[i]) < 0.1);
  CHECK(near.covariance == far.covariance);
  CHECK(norm(far.centroid - (near.centroid + kFar)) < 1e-8);
}

TEST_CASE("moment__orders_0_to_4__known_values") {
  Task task;
  const Cloud cloud = cloud_of({{1, 0, 0}, {3, 0, 0}, {1, 2, 0}, {3, 2, 4}});
  CHECK(moment_of(cloud, 0, 0, 0, true, task) == 1);
  CHECK(moment_of(cloud, 1, 0, 0, false, task) == 2);
  CHECK(moment_of(cloud, 1, 0, 0, true, task) == 0);
  CHECK(moment_of(cloud, 2, 0, 0, true, task) == 1);
  CHECK(moment_of(cloud, 2, 0, 0, false, task) == 5);
  CHECK(moment_of(cloud, 1, 1, 1, false, task) == 6);
  CHECK(moment_of(cloud, 4, 0, 0, true, task) == 1);
  CHECK(status_of([&] { moment_of(Cloud(), 1, 0, 0, true, task); }) == Status::kInsufficientData);
  CHECK(status_of([&] { covariance_of(Cloud(), task); }) == Status::kInsufficientData);
}

TEST_CASE("moment__centred_of_a_normal_distribution__third_is_0_fourth_is_3_sigma_4") {
  RandomStream random(42, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 200000; ++i) points.push_back({random.normal(), 0, 0});
  Task task;
  const Cloud cloud = cloud_of(shifted(points, kFar));
  CHECK(std::fabs(moment_of(cloud, 3, 0, 0, true, task)) < 0.03);
  CHECK(moment_of(cloud, 4, 0, 0, true, task) == doctest::Approx(3).epsilon(0.03));
}

}  // namespace
}  // namespace jalon
