// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/contamination.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace jalon;

namespace {

constexpr double kContaminationSigma_m = 0.006, kContaminationTolerance_m = 0.025;

double normal_density(double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); }

// Midpoint rule over [-limit, limit].
template <class F>
double integral(double limit, F&& f) {
  constexpr int kSteps = 20000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += f(limit * ((2.0 * i + 1) / kSteps - 1));
  return sum * 2 * limit / kSteps;
}

}  // namespace

TEST_CASE("lost_by_truncation__is_what_cutting_takes_from_the_variance") {
  for (const double k : {0.5, 1.0, 2.58, 5.0}) {
    const double mass = integral(k, normal_density);
    const double variance = integral(k, [](double z) { return z * z * normal_density(z); }) / mass;
    CHECK(1 - lost_by_truncation(k * kContaminationSigma_m, kContaminationSigma_m) ==
          doctest::Approx(variance).epsilon(1e-6).scale(0));
  }
}

TEST_CASE("contamination_table__pure_core__is_the_truncated_normal_density") {
  const ContaminationTable table({kContaminationSigma_m, kContaminationTolerance_m, 0, 0},
                                 ContaminationTable::With::kLogDensity);
  const double mass = integral(kContaminationTolerance_m / kContaminationSigma_m, normal_density);
  for (const double r : {-0.02, -0.003, 0.0, 0.006, 0.019}) {
    const auto w = table.weights(r);
    const double density = normal_density(r / kContaminationSigma_m) / kContaminationSigma_m / mass;
    CHECK(std::exp(table.log_density(r)) == doctest::Approx(density).epsilon(0.002).scale(0));
    CHECK(w.slope == doctest::Approx(-r / (kContaminationSigma_m * kContaminationSigma_m))
                         .epsilon(0.002)
                         .scale(1 / kContaminationSigma_m));  // 1/m
    CHECK(w.core == doctest::Approx(1));
    CHECK(w.front == 0);
    CHECK(w.behind == 0);
  }
}

TEST_CASE("contamination_table__mixture__integrates_to_one_and_gives_the_shares_back") {
  const Contamination c{kContaminationSigma_m, kContaminationTolerance_m, 0.2, 0.1};
  const ContaminationTable table(c, ContaminationTable::With::kLogDensity);
  const auto expected = [&](auto&& part) {
    return integral(kContaminationTolerance_m, [&](double r) {
      const auto w = table.weights(r);
      return part(w) * std::exp(table.log_density(r));
    });
  };
  using W = ContaminationTable::Weights;
  // Blurring carries some of the even ones over both ends: to within the interpolation's 0.001 they balance.
  CHECK(expected([](const W&) { return 1.0; }) == doctest::Approx(1).epsilon(0.003));
  CHECK(expected([](const W& w) { return w.core; }) ==
        doctest::Approx(c.core()).epsilon(0.003).scale(0));
  CHECK(expected([](const W& w) { return w.front; }) ==
        doctest::Approx(0.2).epsilon(0.003).scale(0));
  CHECK(expected([](const W& w) { return w.behind; }) ==
        doctest::Approx(0.1).epsilon(0.003).scale(0));
}

TEST_CASE("contamination_table__front_and_behind_mirror_each_other_and_ends_hold_beyond") {
  const ContaminationTable table({kContaminationSigma_m, kContaminationTolerance_m, 0.2, 0.1},
                                 ContaminationTable::With::kDerivatives),
      mirror({kContaminationSigma_m, kContaminationTolerance_m, 0.1, 0.2},
             ContaminationTable::With::kDerivatives);
  for (const double r : {-0.024, -0.01, 0.0, 0.004, 0.017}) {
    const auto a = table.weights(r), b = mirror.weights(-r);
    CHECK(a.front == doctest::Approx(b.behind).scale(0));
    CHECK(table.log_density(r) == doctest::Approx(mirror.log_density(-r)));
    CHECK(a.slope == doctest::Approx(-b.slope).epsilon(1e-6).scale(0));
    using T = ContaminationTable;
    CHECK(table.derivatives(r)[T::kF] == doctest::Approx(mirror.derivatives(-r)[T::kB]).scale(0));
  }
  CHECK(table.log_density(1) == table.log_density(kContaminationTolerance_m));
  CHECK(table.weights(-1).front == table.weights(-kContaminationTolerance_m).front);
}
