// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Centres of patterns drawn at random places of their plane, against where they were drawn.

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/random.h"
#include "registration/targets/intensity_pattern.h"

using namespace jalon;

namespace {

constexpr double kSize_m = 0.2, kNear_m = 0.03;

struct Drawn {
  std::vector<BrightPoint> points;
  Vec2 centre;
};

enum class Painted { kChecker, kDisc, kNothing };

// n points over a square of 0.4 m, a pattern near its middle, its brightness (of about 1) with noise.
Drawn drawn(Painted painted, int n, uint64_t draw, double contrast = 0.8) {
  RandomStream random(161, draw);
  const auto about = [&](double half) { return half * (2 * random.uniform() - 1); };
  Drawn out;
  out.centre = {about(0.015), about(0.015)};
  const double turn = random.uniform(), c = std::cos(turn), s = std::sin(turn);
  for (int i = 0; i < n; ++i) {
    const double u = about(0.2), v = about(0.2);
    const Vec2 d = Vec2{u, v} - out.centre;
    bool bright = norm(d) < kSize_m / 2;
    if (painted == Painted::kChecker) bright = (c * d.u + s * d.v > 0) == (c * d.v - s * d.u > 0);
    const double value = painted == Painted::kNothing ? 0 : bright ? contrast : -contrast;
    out.points.push_back({u, v, 1 + value + 0.08 * random.normal()});
  }
  return out;
}

std::optional<PatternCentre> found_in(Painted painted, const std::vector<BrightPoint>& points) {
  Task task;
  return painted == Painted::kDisc ? find_disc(points, kSize_m, kNear_m, task)
                                   : find_checker(points, kSize_m, kNear_m, task);
}

// d^T C^-1 d of two dimensions.
double squared_miss(const PatternCentre& found, const Vec2& truth) {
  const Vec2 d = found.centre - truth;
  const auto& c = found.covariance;
  return (c[3] * d.u * d.u - 2 * c[1] * d.u * d.v + c[0] * d.v * d.v) / (c[0] * c[3] - c[1] * c[2]);
}

}  // namespace

TEST_CASE("find_pattern__centres_scatter_as_their_covariances_say") {
  constexpr int kDraws = 40;
  for (const Painted painted : {Painted::kChecker, Painted::kDisc}) {
    double sum = 0;
    for (uint64_t draw = 0; draw < kDraws; ++draw) {
      const Drawn d = drawn(painted, 800, draw);
      const auto found = found_in(painted, d.points);
      REQUIRE(found);
      CHECK(found->explained > 0.7);
      sum += squared_miss(*found, d.centre);
      // Points are 1.4 cm apart: edges are told to a part of that over the root of those beside them.
      CHECK(norm(found->centre - d.centre) < 0.006);
      if (painted == Painted::kDisc)
        CHECK(std::abs(found->radius_m - kSize_m / 2) < 5 * found->radius_sigma_m);
      else CHECK(found->radius_m == 0);
    }
    // Chi-square of 2 in the mean of so many: 2 within four times 2 / sqrt(n).
    CHECK(std::abs(sum / kDraws - 2) < 8 / std::sqrt(kDraws));
  }
}

TEST_CASE("find_pattern__is_the_same_with_dark_and_bright_swapped_and_another_level") {
  for (const Painted painted : {Painted::kChecker, Painted::kDisc}) {
    const Drawn d = drawn(painted, 900, 77);
    std::vector<BrightPoint> other = d.points;
    for (BrightPoint& p : other) p.value = 10 - 3 * p.value;
    const auto found = found_in(painted, d.points), swapped = found_in(painted, other);
    REQUIRE(found);
    REQUIRE(swapped);
    // Iterations end at 1e-7 of the size; the covariance is of the derivatives there.
    CHECK(norm(found->centre - swapped->centre) < 1e-6 * kSize_m);
    CHECK(found->explained == doctest::Approx(swapped->explained).scale(0).epsilon(1e-6));
    CHECK(found->covariance[0] == doctest::Approx(swapped->covariance[0]).scale(0).epsilon(1e-3));
    CHECK(found->points == swapped->points);
  }
}

TEST_CASE("find_pattern__finds_every_one_alike_in_whatever_unit_brightness_is") {
  for (const Painted painted : {Painted::kChecker, Painted::kDisc})
    for (uint64_t draw = 100; draw < 150; ++draw) {
      CAPTURE(draw);
      const Drawn d = drawn(painted, 1200, draw);
      const auto found = found_in(painted, d.points);
      REQUIRE(found);
      for (const double unit : {0x1p-10, 0x1p7, 0x1p15, 100.0, 3e4}) {
        std::vector<BrightPoint> other = d.points;
        for (BrightPoint& p : other) p.value *= unit;
        const auto again = found_in(painted, other);
        REQUIRE(again);
        // Powers of two cost no bit; other factors round.
        const double bound_m = unit == 100 || unit == 3e4 ? 1e-6 * kSize_m : 0;
        CHECK(norm(found->centre - again->centre) <= bound_m);
        CHECK(again->covariance[0] == doctest::Approx(found->covariance[0]).scale(0).epsilon(1e-3));
        CHECK(found->points == again->points);
      }
    }
}

TEST_CASE("find_pattern__of_even_brightness_and_of_few_points_there_is_none_worth_the_name") {
  for (const Painted asked : {Painted::kChecker, Painted::kDisc}) {
    std::vector<BrightPoint> even = drawn(Painted::kNothing, 900, 5).points;
    const auto of_noise = found_in(asked, even);
    CHECK((!of_noise || of_noise->explained < 0.1));
    for (BrightPoint& p : even) p.value = 0.17;
    CHECK_FALSE(found_in(asked, even));
    // A dozen points in the reach of a pattern; 24 are the least.
    CHECK_FALSE(found_in(asked, drawn(asked, asked == Painted::kChecker ? 70 : 26, 6).points));
    CHECK_FALSE(found_in(asked, {}));
  }
  // A disc is no checker, and says less as one.
  const Drawn disc = drawn(Painted::kDisc, 900, 7);
  const auto as_checker = found_in(Painted::kChecker, disc.points);
  CHECK((!as_checker || as_checker->explained < 0.5));
}
