// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/range_sample.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

/// Corners of a unit square, by turns 3 mm above and below it: its plane is the middle one.
std::vector<Vec3> rocking_square() {
  return {{0, 0, 0.003}, {1, 0, -0.003}, {1, 1, 0.003}, {0, 1, -0.003}};
}

Cloud with_intensity(Cloud cloud, const std::vector<float>& values) {
  cloud.fields.set(make_column<float>({"intensity", ElementType::kFloat32, 1, "", ""}, values));
  return cloud;
}

TEST_CASE("range_sample__divides_by_n_minus_1_where_the_fit_divides_by_n_minus_3") {
  for (const Vec3& at : {Vec3{}, kFar}) {
    Task task;
    const RangeSample sample = range_sample(cloud_of(shifted(rocking_square(), at)), {}, task);
    CHECK(sample.range_precision_m ==
          doctest::Approx(0.003 * std::sqrt(4.0 / 3)).epsilon(1e-6).scale(0));
    CHECK(sample.fit.sigma == doctest::Approx(0.003 * std::sqrt(4.0)).epsilon(1e-6).scale(0));
    CHECK(std::abs(sample.fit.plane.normal.z) == doctest::Approx(1));
    CHECK(std::isnan(sample.mean_intensity));
  }
}

TEST_CASE("range_sample__takes_only_the_points_named") {
  auto points = rocking_square();
  points.push_back({5, 5, 90});
  points.push_back({-5, 2, -70});
  const std::vector<uint64_t> square = {3, 1, 0, 2};
  Task task;
  CHECK(range_sample(cloud_of(points), square, task).range_precision_m ==
        doctest::Approx(0.003 * std::sqrt(4.0 / 3)).scale(0));
}

TEST_CASE("range_sample__intensities_leave_out_what_is_no_number") {
  Task task;
  const Cloud some = with_intensity(cloud_of(rocking_square()), {1000, NAN, 1004, 1008});
  CHECK(range_sample(some, {}, task).mean_intensity == doctest::Approx(1004));
  CHECK(range_sample(some, {}, task).std_intensity == doctest::Approx(4));
  const Cloud one = with_intensity(cloud_of(rocking_square()), {7, NAN, NAN, NAN});
  CHECK(range_sample(one, {}, task).mean_intensity == doctest::Approx(7));
  CHECK(std::isnan(range_sample(one, {}, task).std_intensity));
  const Cloud none = with_intensity(cloud_of(rocking_square()), {NAN, NAN, NAN, NAN});
  CHECK(std::isnan(range_sample(none, {}, task).mean_intensity));
}

TEST_CASE("range_sample__refuses_two_points_lines_and_indices_out_of_range") {
  Task task;
  const auto refusal = [&](const std::vector<Vec3>& points, std::vector<uint64_t> indices) {
    return status_of([&] { range_sample(cloud_of(points), indices, task); });
  };
  CHECK(refusal({{0, 0, 0}, {1, 0, 0}}, {}) == Status::kInsufficientData);
  CHECK(refusal(rocking_square(), {0, 1}) == Status::kInsufficientData);
  CHECK(refusal(rocking_square(), {0, 1, 4}) == Status::kInvalidArgument);
  CHECK(refusal({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {}) == Status::kDegenerate);
}

}  // namespace
}  // namespace jalon
