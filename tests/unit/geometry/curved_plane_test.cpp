// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/curved_plane.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"

using namespace jalon;

namespace {

constexpr double kLengthU_m = 2, kLengthV_m = 0.5;

// Points of d = height(u, v), u and v in metres.
template <class F>
BendSums sums_of(size_t n, F&& height) {
  RandomStream random(4, 4);
  BendSums sums;
  for (size_t i = 0; i < n; ++i) {
    const double u = kLengthU_m * (2 * random.uniform() - 1),
                 v = kLengthV_m * (2 * random.uniform() - 1);
    sums.add(u / kLengthU_m, v / kLengthV_m, height(u, v));
  }
  return sums;
}

}  // namespace

TEST_CASE("largest_bend__exact_paraboloids__have_their_largest_curvature") {
  Bend bend;
  // 0.1 along u, -0.3 along v, on a slope.
  REQUIRE(largest_bend(sums_of(200,
                               [](double u, double v) {
                                 return 0.01 + 0.02 * u - 0.1 * v + 0.05 * u * u - 0.15 * v * v;
                               }),
                       kLengthU_m, kLengthV_m, bend));
  CHECK(bend.curvature == doctest::Approx(-0.3));
  CHECK(bend.sigma < 1e-6);
  // A cylinder whose axis lies at 30 degrees: 0.4 across it.
  const double c = std::cos(0.5236), s = std::sin(0.5236);
  REQUIRE(largest_bend(
      sums_of(200, [&](double u, double v) { return 0.2 * (s * u - c * v) * (s * u - c * v); }),
      kLengthU_m, kLengthV_m, bend));
  CHECK(bend.curvature == doctest::Approx(0.4));
}

TEST_CASE("largest_bend__noise_on_a_plane__stays_within_its_own_sigma") {
  RandomStream noise(8, 8);
  int beyond = 0;
  for (int draw = 0; draw < 200; ++draw) {
    BendSums sums;
    for (int i = 0; i < 100; ++i) {
      const double u = 2 * noise.uniform() - 1, v = 2 * noise.uniform() - 1;
      sums.add(u, v, 0.003 * noise.normal());
    }
    Bend bend;
    REQUIRE(largest_bend(sums, kLengthU_m, kLengthV_m, bend));
    beyond += std::fabs(bend.curvature) > 3 * bend.sigma;
  }
  CHECK(beyond <= 10);  // the larger of two directions, chosen after the event: some 1 %
}

TEST_CASE("largest_bend__few_points_or_all_on_one_conic__false") {
  Bend bend;
  const auto flat = [](double, double) { return 0.0; };
  CHECK_FALSE(largest_bend(BendSums{}, 1, 1, bend));
  CHECK_FALSE(largest_bend(sums_of(6, flat), kLengthU_m, kLengthV_m, bend));
  CHECK(largest_bend(sums_of(30, flat), kLengthU_m, kLengthV_m, bend));
  CHECK(bend.curvature == doctest::Approx(0));
  BendSums circle, lines;
  for (int i = 0; i < 50; ++i) {
    circle.add(std::cos(0.3 * i), std::sin(0.3 * i), 0);
    lines.add(i % 2, 0.02 * i, 0);
  }
  CHECK_FALSE(largest_bend(circle, 1, 1, bend));
  CHECK_FALSE(largest_bend(lines, 1, 1, bend));
}

TEST_CASE("bend_sums__of_parts_add_up_to_those_of_all") {
  BendSums all, first, second;
  for (int i = 0; i < 40; ++i) {
    const double u = 0.125 * (i % 7), v = 0.25 * (i % 5), d = 0.5 * (i % 3);  // exact sums
    all.add(u, v, d);
    (i < 13 ? first : second).add(u, v, d);
  }
  first += second;
  CHECK(first.products == all.products);
  CHECK(first.heights == all.heights);
  CHECK(first.squares == all.squares);
  CHECK(first.n == all.n);
}
