// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/ranging.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "base/random.h"

using namespace jalon;

TEST_CASE("ranging__intensity_falls_with_the_square_of_the_range_and_the_angle") {
  const double full = returned_intensity(1, 0, 4, 10, 0);
  CHECK(returned_intensity(0.5, 0, 4, 20, 0) == doctest::Approx(full / 8).scale(0));
  CHECK(returned_intensity(1, std::numbers::pi / 3, 4, 10, 0) ==
        doctest::Approx(full / 16).scale(0));
  CHECK(returned_intensity(1, std::numbers::pi / 3, 1, 10, 0) ==
        doctest::Approx(full / 2).scale(0));
  CHECK(returned_intensity(1, 2, 4, 10, 0) == 0);
  const double gamma = attenuation_per_m(1e-4, 2e-4, 3e-4, 4e-4);
  CHECK(returned_intensity(1, 0, 4, 10, gamma) == doctest::Approx(full * std::exp(-0.01)).scale(0));
}

TEST_CASE("ranging__instrument_and_georeferencing_formulas_by_hand") {
  CHECK(pulse_noise_m(1e9, 10, 1) == doctest::Approx(0.35 * 299792458 / 2e10).scale(0));
  CHECK(pulse_noise_m(1e9, 10, 4) == doctest::Approx(pulse_noise_m(1e9, 10, 1) / 2).scale(0));
  CHECK(beam_sigma_m(4e-4, 50) == doctest::Approx(0.005).scale(0));
  CHECK(time_walk_m(1e-9, 0.5, 1) == 0);
  CHECK(time_walk_m(1e-9, 0.5, 2) == doctest::Approx(299792458 * 1e-9 * 0.25).scale(0));
  CHECK(time_walk_m(1e-9, 0.5, 0.5) == doctest::Approx(-299792458 * 1e-9 * 0.5).scale(0));
  CHECK(temperature_drift_m(0.004 / 30, 30) == doctest::Approx(0.004).scale(0));
  CHECK(azimuth_sigma_rad(0.002, 50) == doctest::Approx(std::sqrt(2.0) * 4e-5).scale(0));
  CHECK(levelling_sigma_rad(1e-4) == doctest::Approx(2e-5).scale(0));
}

TEST_CASE("ranging__close_wavelengths_give_the_range_by_their_beats") {
  // Annex A.4: 29.97, 30.04492, 31.4685 MHz.
  const std::vector<double> lambdas{kSpeedOfLight_m_s / 29.97e6, kSpeedOfLight_m_s / 30.04492e6,
                                    kSpeedOfLight_m_s / 31.4685e6};
  CHECK(lambdas[0] == doctest::Approx(10.003).epsilon(1e-4));
  CHECK(lambdas[0] * lambdas[1] / (lambdas[0] - lambdas[1]) ==
        doctest::Approx(4001.5).epsilon(1e-4));
  CHECK(lambdas[0] * lambdas[2] / (lambdas[0] - lambdas[2]) ==
        doctest::Approx(200.1).epsilon(1e-3));
  RandomStream random(2, 2);
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    const double range = 1999 * random.uniform();
    std::vector<double> remainders;
    for (const double lambda : lambdas) {
      const double noisy = std::fmod(2 * range, lambda) + 0.002 * random.normal();
      remainders.push_back(std::clamp(noisy, 0.0, lambda));
    }
    worst = std::max(worst, std::fabs(phase_range_m(lambdas, remainders) - range));
  }
  MESSAGE("FIGURE phase ranging with 2 mm of noise: largest error ", 1000 * worst,
          " mm up to 2 km");
  CHECK(worst < 0.005);
}

TEST_CASE("ranging__common_wavelengths_has_the_corrected_sign") {
  const double lambda1 = 10.003, lambda2 = 9.978, twice = 146.469;
  const double m = std::floor(twice / lambda1);
  REQUIRE(m == std::floor(twice / lambda2));  // both hold the same number
  CHECK(common_wavelengths(lambda1, twice - m * lambda1, lambda2, twice - m * lambda2) == m);
  CHECK(common_wavelengths(lambda2, twice - m * lambda2, lambda1, twice - m * lambda1) == m);
}

TEST_CASE("ranging__nested_wavelengths_go_from_coarse_to_fine") {
  const std::vector<double> lambdas{1, 1000, 10, 100};
  for (const double range : {0.123, 49.876, 321.321, 499.0}) {
    std::vector<double> remainders;
    for (const double lambda : lambdas) remainders.push_back(std::fmod(2 * range, lambda));
    CHECK(phase_range_m(lambdas, remainders) == doctest::Approx(range).epsilon(1e-9));
  }
  const double equal[] = {5, 5}, zeros[] = {0, 0}, beyond[] = {6, 0}, lengths[] = {5, 4};
  CHECK_THROWS_AS(phase_range_m(equal, zeros), Error);
  CHECK_THROWS_AS(phase_range_m(lengths, beyond), Error);
  CHECK_THROWS_AS(phase_range_m({}, {}), Error);
}

TEST_CASE("ranging__a_baseline_of_ten_distances_gives_its_constant_within_half_a_millimetre") {
  // DS8: k = 7.8 mm, noise 1.5 mm; sigma of k is 0.47 mm, so that two thirds of the surveys are within 0.5 mm.
  const double truth[] = {7, 9, 12, 14, 17, 19, 22, 25, 28, 31};
  int within = 0, covered = 0;
  constexpr int kSurveys = 2000;
  for (int k = 0; k < kSurveys; ++k) {
    RandomStream random(8, static_cast<uint64_t>(k));
    double measured[10];
    for (size_t i = 0; i < 10; ++i) measured[i] = truth[i] + 0.0078 + 0.0015 * random.normal();
    const BaselineConstant found = baseline_constant(measured, truth);
    within += std::fabs(found.constant_m - 0.0078) < 0.0005;
    covered += std::fabs(found.constant_m - 0.0078) <
               2.262 * found.sigma_constant_m;  // Student, 9 degrees of freedom
  }
  MESSAGE("FIGURE baseline: ", within * 100.0 / kSurveys,
          " % of the constants within 0.5 mm, 95 % interval covers ", covered * 100.0 / kSurveys,
          " %");
  CHECK(within > 0.67 * kSurveys);
  CHECK(covered > 0.935 * kSurveys);
  CHECK(covered < 0.965 * kSurveys);
}
