// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The colour scale of distances: its steps, its order of lightness, and how many distances lie within it.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "report/pictures/deviation_colours.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;

namespace {

DeviationScale scale_of(const std::vector<double>& distances, double limit_m = 0) {
  const Comparison comparison = page_scenes::comparison_of(distances);
  const Comparison* one[] = {&comparison};
  return deviation_scale(one, limit_m);
}

// Relative luminance (ITU-R BT.709) of the code values: falls and rises as the lightness does.
double lightness(const Rgb& c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; }

}  // namespace

TEST_CASE("deviation_colours__a_distance_lies_in_its_step_and_what_is_beyond_in_the_last") {
  RandomStream random(1, 2);
  for (const bool is_signed : {false, true}) {
    const DeviationScale scale{0.05, is_signed};
    const double low = is_signed ? -0.05 : 0, width = (0.05 - low) / DeviationScale::kSteps;
    for (int i = 0; i < 2000; ++i) {
      const double d = low + (0.05 - low) * random.uniform();
      const double step = scale.step_of(d);
      CHECK(d >= low + step * width - 1e-15);  // rounding of the division
      CHECK(d <= low + (step + 1) * width + 1e-15);
    }
    CHECK(scale.step_of(low) == 0);
    CHECK(scale.step_of(low - 1) == 0);
    CHECK(scale.step_of(0.05) == DeviationScale::kSteps - 1);
    CHECK(scale.step_of(1e300) == DeviationScale::kSteps - 1);
    CHECK(scale.step_of(INFINITY) == DeviationScale::kSteps - 1);
    CHECK(scale.step_of(-INFINITY) == 0);
  }
}

TEST_CASE("deviation_colours__get_darker_away_from_zero_with_blue_for_what_lies_behind") {
  const DeviationScale plain{1, false}, both{1, true};
  constexpr uint32_t kLast = DeviationScale::kSteps - 1, kMiddle = DeviationScale::kSteps / 2;
  for (uint32_t step = 0; step < kLast; ++step) {
    CHECK(lightness(plain.colour(step)) > lightness(plain.colour(step + 1)));
    const double here = lightness(both.colour(step)), next = lightness(both.colour(step + 1));
    if (step + 1 < kMiddle) CHECK(here < next);
    if (step >= kMiddle) CHECK(here > next);
    for (const Rgb& other : {kHiddenColour, kNotComparedColour}) {
      CHECK(plain.colour(step) != other);
      CHECK(both.colour(step) != other);
    }
  }
  CHECK(both.colour(0).blue > 2 * both.colour(0).red);
  CHECK(both.colour(kLast).red > 2 * both.colour(kLast).blue);
  const Rgb white = both.colour(kMiddle);
  CHECK(std::min({white.red, white.green, white.blue}) > 0xe0);
}

TEST_CASE("deviation_colours__the_limit_is_the_least_round_one_that_holds_98_percent") {
  constexpr double kRound[] = {1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02,
                               0.05, 0.1,  0.2,  0.5,  1,    2,    5,    10};
  for (uint64_t seed = 0; seed < 10; ++seed) {
    RandomStream random(seed, 4);
    const double size = 0.001 * std::pow(2.3, static_cast<double>(seed));
    std::vector<double> distances(400);
    for (double& d : distances) d = size * random.normal();
    distances[0] = NAN;
    const auto share_within = [&](double limit) {
      return static_cast<double>(std::count_if(distances.begin(), distances.end(),
                                               [&](double d) { return std::abs(d) <= limit; })) /
             399;
    };
    const double limit = scale_of(distances).limit_m;
    CAPTURE(limit);
    const auto at = std::find_if(std::begin(kRound), std::end(kRound),
                                 [&](double r) { return std::abs(limit / r - 1) < 1e-12; });
    REQUIRE(at != std::end(kRound));
    CHECK(share_within(limit) >= 0.98 - 1 / 399.0);  // the one at the border may be either
    CHECK(share_within(at[-1]) < 0.98 + 1 / 399.0);
  }
}

TEST_CASE("deviation_colours__scale_is_signed_when_a_distance_is_and_serves_all_comparisons") {
  CHECK(!scale_of({0, 0.1, NAN}).is_signed);
  CHECK(scale_of({0, 0.1, -1e-9}).is_signed);
  CHECK(scale_of({0.3, 5}, 0.123).limit_m == 0.123);
  CHECK(scale_of({NAN, NAN}).limit_m == 1);
  CHECK(scale_of({}).limit_m == 1);
  CHECK(scale_of({0, 0, 0}).limit_m > 0);
  CHECK(scale_of({0, 0, 0}).step_of(0) == 0);
  const Comparison small = page_scenes::comparison_of({0.01, 0.01}),
                   large = page_scenes::comparison_of(std::vector<double>(98, -3));
  for (const auto& pair : {std::array{&small, &large}, std::array{&large, &small}}) {
    const DeviationScale scale = deviation_scale(pair, 0);
    CHECK(scale.is_signed);
    CHECK(scale.limit_m == 5);
  }
}
