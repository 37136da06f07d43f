// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Fitted laws: the likelihood is highest where they say, and they follow when the values are scaled or moved.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "fieldtools/noise_law.h"
#include "unit/cloud/clouds.h"
#include "unit/compare/refusal.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// By the inverse of the cumulative.
std::vector<double> weibull_sample(size_t n, double shape, double scale, double shift,
                                   uint64_t seed) {
  NoiseLaw law;
  law.kind = LawKind::kWeibull;
  law.shape = shape;
  law.scale = scale;
  RandomStream random(seed, 5);
  std::vector<double> out(n);
  for (double& v : out) v = shift + law.quantile(random.uniform());
  return out;
}

double log_likelihood(const NoiseLaw& law, const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += std::log(law.density(v));
  return sum;
}

}  // namespace

TEST_CASE("fit_weibull__no_law_nearby_is_more_likely_and_the_true_one_is_near") {
  Task task;
  for (const double shape : {0.7, 1.0, 1.8, 6.0}) {
    const auto values = weibull_sample(4000, shape, 0.01, 0, 1);
    const NoiseLaw law = fit_weibull(values, 0, task);
    // Standard deviations of the estimates: 0.78 a / sqrt(n), 1.05 b / (a sqrt(n)); four of them.
    const double root = std::sqrt(4000.0);
    CHECK(std::fabs(law.shape - shape) < 4 * 0.78 * shape / root);
    CHECK(std::fabs(law.scale - 0.01) < 4 * 1.05 * 0.01 / (shape * root));
    const double best = log_likelihood(law, values);
    for (const double factor : {0.98, 0.999, 1.001, 1.02}) {
      NoiseLaw other = law;
      other.shape *= factor;
      CHECK(log_likelihood(other, values) < best);
      other = law;
      other.scale *= factor;
      CHECK(log_likelihood(other, values) < best);
    }
  }
}

TEST_CASE("fit_weibull__scaled_and_moved_values_scale_and_move_the_law") {
  Task task;
  const auto values = weibull_sample(3000, 2.2, 0.004, 0, 2);
  const NoiseLaw law = fit_weibull(values, 0, task);
  auto scaled = values, moved = values;
  for (double& v : scaled) v *= 1e6;
  for (double& v : moved) v += 0.5;
  const NoiseLaw large = fit_weibull(scaled, 0, task), far = fit_weibull(moved, 0.5, task);
  CHECK(large.shape == doctest::Approx(law.shape).epsilon(1e-9));
  CHECK(large.scale == doctest::Approx(1e6 * law.scale).epsilon(1e-9));
  CHECK(far.shape == doctest::Approx(law.shape).epsilon(1e-9));  // 0.5 costs three of 16 digits
  CHECK(far.shift == 0.5);
  auto more = moved;  // at the shift or below it
  more.insert(more.end(), {0.5, 0.25, 0.0, -3.0});
  CHECK(fit_weibull(more, 0.5, task).shape == doctest::Approx(far.shape).epsilon(1e-12));
  CHECK(far.cumulative(0.503) == doctest::Approx(law.cumulative(0.003)).epsilon(1e-9));
}

TEST_CASE("most_likely_shift__moves_with_the_values_and_is_none_where_likelihood_has_no_summit") {
  Task task;
  auto values = weibull_sample(2500, 3, 0.02, 0, 3);
  std::sort(values.begin(), values.end());
  const double shift = most_likely_shift(values, task);
  CHECK(shift < values.front());
  const double gap = values.front() - shift,
               best = log_likelihood(fit_weibull(values, shift, task), values);
  for (const double factor : {0.9, 1.1}) {
    const NoiseLaw other = fit_weibull(values, values.front() - factor * gap, task);
    CHECK(log_likelihood(other, values) < best);
  }
  for (double& v : values) v += 0.25;
  CHECK(most_likely_shift(values, task) == doctest::Approx(shift + 0.25).epsilon(1e-6));
  // Shapes below 1 have their density infinite at the shift: the likelihood rises towards the smallest value.
  auto steep = weibull_sample(2500, 0.5, 0.02, 0, 4);
  std::sort(steep.begin(), steep.end());
  CHECK(most_likely_shift(steep, task) == 0);
}

TEST_CASE("fit_noise_law__gauss_and_empirical_are_the_moments_and_the_sample_itself") {
  Task task;
  const std::vector<double> values{3, -1, kNaN, 4, 1, -5, 9, 2, -6, 5, 3, 5};
  NoiseLawSettings set;
  set.law = NoiseLawSettings::Law::kGauss;
  const NoiseLaw gauss = fit_noise_law(values, set, task);
  CHECK(gauss.samples == 11);
  CHECK(gauss.gauss_mean == doctest::Approx(20.0 / 11));
  CHECK(gauss.gauss_sigma == doctest::Approx(std::sqrt(232.0 / 11 - 400.0 / 121)));
  set.law = NoiseLawSettings::Law::kEmpirical;
  const NoiseLaw sample = fit_noise_law(values, set, task);
  std::vector<double> sorted = values;
  sorted.erase(sorted.begin() + 2);
  std::sort(sorted.begin(), sorted.end());
  CHECK(sample.quantiles == sorted);
  CHECK(sample.quantile(0.5) == 3);
  auto many = weibull_sample(20000, 2, 1, 0, 5);
  std::sort(many.begin(), many.end());
  const NoiseLaw thinned_law = empirical_law(many);
  CHECK(thinned_law.quantiles.front() == many.front());
  CHECK(thinned_law.quantiles.back() == many.back());
  for (size_t i = 0; i < many.size(); i += 37)  // thinned to 4 096 steps
    CHECK(std::fabs(thinned_law.cumulative(many[i]) - static_cast<double>(i) / 19999) < 1.3 / 4095);
}

TEST_CASE("fit_noise_law__values_without_a_law_are_told_why") {
  Task task;
  NoiseLawSettings set;
  const auto fit = [&](std::vector<double> values, NoiseLawSettings::Law law) {
    return [&, values, law] {
      set.law = law;
      fit_noise_law(values, set, task);
    };
  };
  using Law = NoiseLawSettings::Law;
  CHECK(refuses(fit({1, 2, 3, 4, 5, 6, 7, 8, kNaN}, Law::kGauss), Status::kInsufficientData,
                "8 values"));
  CHECK(refuses(fit(std::vector<double>(20, 2.5), Law::kGauss), Status::kDegenerate, "equal"));
  CHECK(refuses(fit(std::vector<double>(20, 2.5), Law::kEmpirical), Status::kDegenerate, "equal"));
  CHECK(refuses(fit(std::vector<double>(20, 2.5), Law::kWeibull), Status::kDegenerate, "scatter"));
  std::vector<double> signed_values;
  for (int i = 0; i < 30; ++i) signed_values.push_back(i - 20);
  CHECK(refuses(fit(signed_values, Law::kWeibull), Status::kDegenerate, "gauss"));
}
