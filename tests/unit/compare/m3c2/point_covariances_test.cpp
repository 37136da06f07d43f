// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Variances along normals against n^T C n in full, those of means and medians against the scatter of many samples.
#include "compare/m3c2/point_covariances.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

template <class T>
Cloud with_covariances(const std::vector<std::array<double, 9>>& rows, bool full) {
  std::vector<T> values;
  for (const auto& c : rows)
    for (size_t i = 0; i < 9; ++i)
      if (full || i < 3 || i == 4 || i == 5 || i == 8) values.push_back(static_cast<T>(c[i]));
  Cloud cloud = cloud_of(std::vector<Vec3>(rows.size()));
  cloud.fields.set(make_column<T>({"covariance", element_type_of<T>(), full ? 9u : 6u, "m2", ""},
                                  std::span<const T>(values)));
  return cloud;
}

PropagatedVariance variances_of(const std::vector<double>& sigmas, double factor = 1) {
  PropagatedVariance out;
  for (const double s : sigmas) out.add(factor * s * s);
  return out;
}

}  // namespace

TEST_CASE("point_covariances__of_six_or_nine_numbers_give_the_variance_along_a_normal") {
  RandomStream random(4, 0);
  std::vector<std::array<double, 9>> rows(20);
  for (auto& c : rows) {
    double a[9];
    for (double& x : a) x = random.normal();
    for (size_t i = 0; i < 9; ++i)  // A A^T
      c[i] = a[i / 3 * 3] * a[i % 3 * 3] + a[i / 3 * 3 + 1] * a[i % 3 * 3 + 1] +
             a[i / 3 * 3 + 2] * a[i % 3 * 3 + 2];
  }
  const PointCovariances exact[] = {{with_covariances<double>(rows, false), "reference"},
                                    {with_covariances<double>(rows, true), "reference"}},
                         rounded[] = {{with_covariances<float>(rows, false), "compared"},
                                      {with_covariances<float>(rows, true), "compared"}};
  for (size_t i = 0; i < rows.size(); ++i) {
    const Vec3 n = normalized({random.normal(), random.normal(), random.normal()});
    double truth = 0, size = 0;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        truth += n[r] * rows[i][static_cast<size_t>(3 * r + c)] * n[c];
        size += std::fabs(n[r] * rows[i][static_cast<size_t>(3 * r + c)] * n[c]);
      }
    for (const auto& c : exact) CHECK(std::fabs(c.variance_along(i, n) - truth) < 1e-14 * size);
    // Numbers of 24 bits.
    for (const auto& c : rounded) CHECK(std::fabs(c.variance_along(i, n) - truth) < 0x1p-24 * size);
  }
}

TEST_CASE("point_covariances__say_which_cloud_has_none_or_the_wrong_ones") {
  Cloud cloud = cloud_of({{0, 0, 0}});
  const auto made = [&] { return PointCovariances(cloud, "compared"); };
  CHECK(status_of(made) == Status::kNotFound);
  CHECK_THROWS_WITH_AS(made(), doctest::Contains("the compared cloud"), Error);
  const double three[] = {1, 2, 3};
  cloud.fields.set(make_column<double>({"covariance", ElementType::kFloat64, 3, "", ""},
                                       std::span<const double>(three)));
  CHECK(status_of(made) == Status::kInvalidArgument);
  CHECK_THROWS_WITH_AS(made(), doctest::Contains("the compared cloud"), Error);
  const int32_t six[] = {1, 0, 0, 1, 0, 1};
  cloud.fields.set(make_column<int32_t>({"covariance", ElementType::kInt32, 6, "", ""},
                                        std::span<const int32_t>(six)));
  CHECK(status_of(made) == Status::kInvalidArgument);
}

TEST_CASE("propagated_variance__is_the_scatter_of_means_and_medians_of_such_points") {
  const std::vector<double> sigmas{1, 1.2, 1.5, 2, 2.2, 2.5, 3, 1.1, 4, 1.3, 5, 1.7, 2.1};
  constexpr int kSamples = 4000;
  RandomStream random(8, 1);
  std::vector<double> values(sigmas.size());
  double of_means = 0, of_medians = 0;
  for (int k = 0; k < kSamples; ++k) {
    double sum = 0;
    for (size_t i = 0; i < sigmas.size(); ++i) sum += values[i] = sigmas[i] * random.normal();
    std::nth_element(values.begin(), values.begin() + 6, values.end());
    of_means += std::pow(sum / static_cast<double>(values.size()), 2) / kSamples;
    of_medians += values[6] * values[6] / kSamples;
  }
  const PropagatedVariance found = variances_of(sigmas);
  // A variance from 4000 samples has a standard error of sqrt(2 / 4000) = 2.2 %; four of them.
  CHECK(found.of_mean() == doctest::Approx(of_means).epsilon(0.09).scale(0));
  // The median's rule holds 95 % ranges, not variances: 10 % more.
  CHECK(found.of_median() == doctest::Approx(of_medians).epsilon(0.19).scale(0));
}

TEST_CASE("propagated_variance__scales_and_knows_equal_and_exact_points") {
  const std::vector<double> sigmas{0.002, 0.003, 0.001, 0.004, 0.002, 0.003, 0.005};
  const double one = variances_of(sigmas).of_median();
  CHECK(variances_of(sigmas, 9).of_median() == doctest::Approx(9 * one).epsilon(1e-8).scale(0));
  // 11 points of 2 mm: their median is known to sqrt(pi / 2) of the mean, for samples this small to 5 % of it.
  const PropagatedVariance equal = variances_of(std::vector<double>(11, 0.002));
  CHECK(equal.of_mean() == doctest::Approx(4e-6 / 11).epsilon(1e-12).scale(0));
  CHECK(equal.of_median() ==
        doctest::Approx(std::numbers::pi / 2 * 4e-6 / 11).epsilon(0.05).scale(0));
  CHECK(variances_of({0, 0, 0, 0, 0, 0, 0, 1, 1}).of_median() == 0);
  CHECK(variances_of({0, 0, 0, 0, 0, 0}).of_median() == 0);
  PropagatedVariance again = equal;
  again.clear();
  again.add(7);
  CHECK(again.of_mean() == 7);
}
