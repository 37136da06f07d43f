// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The predicted sampling error where the density changes, with its scale, and where there is nothing to go by.
#include "compare/distance/sampling_error.h"

#include <doctest/doctest.h>

#include <numbers>
#include <numeric>

#include "unit/compare/distance_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

SamplingError predicted(const CloudPtr& reference, const std::vector<uint32_t>& nearest) {
  Task task;
  return predict_sampling_error(*reference->octree(task), nearest, task);
}

std::vector<uint32_t> each_of(const CloudPtr& reference) {
  std::vector<uint32_t> rows(reference->size());
  std::iota(rows.begin(), rows.end(), 0U);
  return rows;
}

}  // namespace

TEST_CASE("sampling_error__of_a_point_follows_the_density_around_its_reference_point") {
  // 1000 points a m2 to the left of x = 2, 4000 to the right: half the distance.
  std::vector<double> xyz = random_square(4000, 2, 0, 1);
  std::vector<double> dense = random_square(16000, 2, 0, 2);
  for (size_t i = 0; i < dense.size(); i += 3) dense[i] += 2;
  xyz.insert(xyz.end(), dense.begin(), dense.end());
  const auto reference = cloud_of(xyz);
  // Queries at random places, 0.3 m and more from the borders.
  std::vector<uint32_t> left, right;
  Task task;
  const auto tree = reference->octree(task);
  RandomStream random(3, 0);
  for (int i = 0; i < 4000; ++i) {
    const double u = 0.3 + 1.4 * random.uniform(), v = 0.3 + 1.4 * random.uniform();
    Neighbour found;
    REQUIRE(tree->nearest_within({u, v, 0}, 1, found));
    left.push_back(found.index);
    REQUIRE(tree->nearest_within({u + 2, v, 0}, 1, found));
    right.push_back(found.index);
  }
  for (const auto& [nearest, lambda] : {std::pair{left, 1000.0}, {right, 4000.0}}) {
    const SamplingError error = predicted(reference, nearest);
    // The 1960 points that the queries lie among scatter by 1.6 %, half of that for roots; three times.
    CHECK(error.rms_m ==
          doctest::Approx(1 / std::sqrt(std::numbers::pi * lambda)).epsilon(0.03).scale(0));
    CHECK(error.mean_m == doctest::Approx(1 / (2 * std::sqrt(lambda))).epsilon(0.03).scale(0));
    double squares = 0;
    for (size_t i = 0; i < nearest.size(); ++i) squares += std::pow(error.column->number(i), 2);
    CHECK(std::sqrt(squares / 4000) ==
          doctest::Approx(error.rms_m).epsilon(1e-6).scale(0));  // float
  }
}

TEST_CASE("sampling_error__grows_with_the_scale_of_the_reference") {
  std::vector<double> xyz = random_square(3000, 4, 0, 4, 0.01);
  const auto reference = cloud_of(xyz);
  for (double& v : xyz) v *= 8;
  const auto large = cloud_of(xyz);
  const SamplingError one = predicted(reference, each_of(reference)),
                      eight = predicted(large, each_of(large));
  CHECK(eight.rms_m == doctest::Approx(8 * one.rms_m).epsilon(1e-6).scale(0));  // float
  CHECK(eight.mean_m == doctest::Approx(8 * one.mean_m).epsilon(1e-6).scale(0));
  for (size_t i = 0; i < 3000; ++i)
    REQUIRE(eight.column->number(i) ==
            doctest::Approx(8 * one.column->number(i)).epsilon(1e-5).scale(0));
}

TEST_CASE("sampling_error__is_nan_without_a_reference_point_and_left_out_of_the_mean") {
  // A square of 4 points: each has 3 others, the farthest at 1.41 m.
  const auto square = cloud_of({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  const SamplingError some = predicted(square, {2, kNoPoint, 0, kNoPoint});
  REQUIRE(some.column->count() == 4);
  CHECK(std::isnan(some.column->number(1)));
  CHECK(std::isnan(some.column->number(3)));
  CHECK(some.column->number(0) == some.column->number(2));
  CHECK(some.rms_m == doctest::Approx(some.column->number(0)).epsilon(1e-6).scale(0));
  // R^2 = 1 / (pi lambda) and 1 / (2 sqrt(lambda)) of one lambda.
  CHECK(some.mean_m / some.rms_m == doctest::Approx(std::sqrt(std::numbers::pi) / 2));
  for (const auto& [reference, nearest] : {std::pair{square, std::vector<uint32_t>(3, kNoPoint)},
                                           {cloud_of({1, 2, 3}), std::vector<uint32_t>{0, 0}},
                                           {square, std::vector<uint32_t>{}}}) {
    const SamplingError none = predicted(reference, nearest);
    CHECK(std::isnan(none.rms_m));
    CHECK(std::isnan(none.mean_m));
    for (size_t i = 0; i < nearest.size(); ++i) CHECK(std::isnan(none.column->number(i)));
  }
}
