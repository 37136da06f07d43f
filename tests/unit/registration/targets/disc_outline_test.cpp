// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Discs and what is none, by their outline in noise that hides the corners.

#include "registration/targets/disc_outline.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

constexpr double kRadius_m = 0.06, kPitch_m = 0.006, kBlur_m = 0.006;
constexpr double kLevel = 100, kContrast = 50, kNoise = 20;  // a fifth of bright less dark

/// inside: how far within the outline, of a dark shape in a bright ground.
double chance(const std::function<double(double, double)>& inside, uint64_t seed,
              double pitch_m = kPitch_m) {
  RandomStream random(97, seed);
  const double turn = random.uniform(), c = std::cos(turn), s = std::sin(turn);
  std::vector<BrightPoint> points;
  std::vector<double> residuals;
  const int n = static_cast<int>(1.6 * kRadius_m / pitch_m);
  for (int i = -n; i <= n; ++i)
    for (int k = -n; k <= n; ++k) {
      const double x = i * pitch_m, y = k * pitch_m;
      const BrightPoint p{
          c * x - s * y, s * x + c * y,
          kLevel - kContrast * std::tanh(inside(x, y) / kBlur_m) + kNoise * random.normal()};
      points.push_back(p);
      residuals.push_back(kLevel - kContrast * std::tanh((kRadius_m - std::hypot(x, y)) / kBlur_m) -
                          p.value);
    }
  return chance_of_disc(points, residuals, kRadius_m, -kContrast);
}

double of_square(double x, double y) {
  constexpr double kHalf_m = 0.0532;  // of the disc's area
  return kHalf_m - std::max(std::fabs(x), std::fabs(y));
}

}  // namespace

TEST_CASE("chance_of_disc__tells_squares_rectangles_and_triangles_in_noise") {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    CHECK(chance([](double x, double y) { return kRadius_m - std::hypot(x, y); }, seed) > 0.95);
    CHECK(chance(of_square, seed) < 0.05);
    CHECK(chance([](double x, double y) { return of_square(1.25 * x, y / 1.25); }, seed) < 0.05);
    CHECK(chance(
              [](double x, double y) {
                return std::min({0.046 + y, 0.046 - y / 2 + 0.866 * x, 0.046 - y / 2 - 0.866 * x});
              },
              seed) < 0.05);
  }
}

TEST_CASE("chance_of_disc__is_even_where_few_points_lie_about_the_border") {
  CHECK(chance(of_square, 1, 0.03) == 0.5);
}
