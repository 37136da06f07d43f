// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Fits through stretches of a chain by running sums, against sums over their points.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"
#include "modelling/edges/find/chain_moments.h"

using namespace jalon;

namespace {

struct Sample {
  std::vector<Vec2> chain;
  std::vector<double> weights;

  explicit Sample(size_t n) {
    RandomStream random(n, 12);
    for (size_t i = 0; i < n; ++i) {
      chain.push_back({5000 + 3 * random.uniform(), -800 + random.uniform()});
      weights.push_back(0.2 + random.uniform());
    }
  }
  double squares(const EdgeLine& line, size_t first, size_t last) const {
    double sum = 0;
    for (size_t i = first; i <= last; ++i) {
      const double d = line.distance(chain[i % chain.size()]);
      sum += weights[i % chain.size()] * d * d;
    }
    return sum;
  }
};

}  // namespace

TEST_CASE("chain_moments__sums_about_a_line_are_those_of_its_points_round_the_chain") {
  const Sample sample(40);
  const ChainMoments moments(sample.chain, sample.weights);
  CHECK(moments.size() == 40);
  for (const auto& [first, last] :
       {std::pair<size_t, size_t>{0, 39}, {5, 17}, {30, 55}, {39, 41}}) {
    double weight = 0;
    Vec2 sum;
    for (size_t i = first; i <= last; ++i) {
      weight += sample.weights[i % 40];
      sum = sum + (sample.chain[i % 40] - sample.chain[0]) * sample.weights[i % 40];
    }
    CHECK(norm(moments.stretch(first, last).mean() - (sample.chain[0] + sum * (1 / weight))) <
          1e-9);
    const EdgeLine line{{5001, -800.5}, {0.6, 0.8}};
    CHECK(moments.stretch(first, last).squares_about(line) ==
          doctest::Approx(sample.squares(line, first, last)));
  }
}

TEST_CASE("chain_moments__no_other_line_is_nearer_to_the_points_than_the_one_fitted") {
  const Sample sample(25);
  const ChainMoments moments(sample.chain, sample.weights);
  const auto fit = moments.stretch(20, 33).line();
  CHECK(norm(fit.line.direction) == doctest::Approx(1));
  CHECK(fit.squares == doctest::Approx(sample.squares(fit.line, 20, 33)));
  for (const double turn : {-0.01, 0.01})
    for (const double shift : {-0.01, 0.0, 0.01}) {
      const Vec2 d = fit.line.direction, left{-d.v, d.u};
      const EdgeLine other{fit.line.point + left * shift,
                           d * std::cos(turn) + left * std::sin(turn)};
      CHECK(sample.squares(other, 20, 33) > fit.squares);
    }
}

TEST_CASE("chain_moments__points_of_a_circle_give_it_back_and_noise_its_squares") {
  const Circle truth{{312, 45}, 2.5};
  RandomStream random(3, 12);
  for (const double noise_m : {0.0, 0.004}) {
    std::vector<Vec2> chain;
    std::vector<double> weights;
    for (int i = 0; i < 60; ++i) {
      const double angle = 0.03 * i, r = truth.radius + noise_m * random.normal();
      chain.push_back(truth.centre + Vec2{r * std::cos(angle), r * std::sin(angle)});
      weights.push_back(0.5 + random.uniform());
    }
    const auto fit = ChainMoments(chain, weights).stretch(0, 59).arc();
    CHECK(norm(fit.circle.centre - truth.centre) <= 3 * noise_m + 1e-6);
    CHECK(std::fabs(fit.circle.radius - truth.radius) <= 3 * noise_m + 1e-6);
    double squares = 0;
    for (size_t i = 0; i < chain.size(); ++i)
      squares += weights[i] * std::pow(fit.circle.distance(chain[i]), 2);
    CHECK(std::fabs(fit.squares - squares) <= 0.01 * squares + 1e-15);
  }
}

TEST_CASE("chain_moments__points_on_a_line_have_no_circle") {
  std::vector<Vec2> chain;
  for (int i = 0; i < 20; ++i) chain.push_back({0.5 * i, 0.25 * i});
  const std::vector<double> weights(20, 1);
  const ChainMoments moments(chain, weights);
  CHECK(moments.stretch(0, 19).arc().squares == INFINITY);
  CHECK(moments.stretch(0, 19).line().squares < 1e-12);
}
