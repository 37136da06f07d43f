// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/circle.h"

#include <doctest/doctest.h>

#include <numbers>
#include <vector>

using namespace jalon;

namespace {

std::vector<Vec2> arc(const Circle& circle, double turn_rad, size_t n, double noise_m) {
  RandomStream random(11, 2);
  std::vector<Vec2> out;
  for (size_t i = 0; i < n; ++i) {
    const double angle = turn_rad * static_cast<double>(i) / static_cast<double>(n);
    const double r = circle.radius + noise_m * random.normal();
    out.push_back(circle.centre + Vec2{r * std::cos(angle), r * std::sin(angle)});
  }
  return out;
}

}  // namespace

TEST_CASE("circle_linear__exact_points_far_from_the_origin__give_the_circle") {
  const Circle truth{{652000.25, -6861000.5}, 0.4};
  Circle found;
  REQUIRE(circle_linear(arc(truth, 2.0, 7, 0), found));
  CHECK(norm(found.centre - truth.centre) < 1e-7);
  CHECK(std::fabs(found.radius - truth.radius) < 1e-7);
  // Circumscribed circle of a right triangle: its middle is that of the hypotenuse.
  REQUIRE(circle_linear(std::vector<Vec2>{{0, 0}, {6, 0}, {0, 8}}, found));
  CHECK(norm(found.centre - Vec2{3, 4}) < 1e-12);
  CHECK(found.radius == doctest::Approx(5));
}

TEST_CASE("circle_fits__points_on_one_line_equal_or_too_few__refused") {
  Circle circle;
  CircleFit fit;
  Task task;
  const std::vector<Vec2> line{{0, 0}, {1, 2}, {2, 4}, {3, 6}, {4, 8}};
  for (const auto& points :
       {line, std::vector<Vec2>(6, Vec2{1, 2}), std::vector<Vec2>{{0, 0}, {1, 0}}, {}}) {
    CHECK_FALSE(circle_linear(points, circle));
    for (const bool robust : {false, true}) {
      PrimitiveSetting setting;
      setting.robust = robust;
      CHECK_FALSE(fit_circle(points, setting, task, fit));
    }
  }
}

TEST_CASE("fit_circle__least_squares__no_circle_nearby_has_a_smaller_sum_of_squares") {
  const std::vector<Vec2> points = arc({{1, -2}, 0.5}, 2.5, 40, 0.01);
  PrimitiveSetting setting;
  setting.robust = false;
  Task task;
  CircleFit fit;
  REQUIRE(fit_circle(points, setting, task, fit));
  const auto squares = [&](const Circle& c) {
    double sum = 0;
    for (const Vec2& p : points) sum += c.distance(p) * c.distance(p);
    return sum;
  };
  const double least = squares(fit.circle);
  for (const double step : {-1e-4, 1e-4}) {
    const Circle& c = fit.circle;
    CHECK(squares({c.centre + Vec2{step, 0}, c.radius}) > least);
    CHECK(squares({c.centre + Vec2{0, step}, c.radius}) > least);
    CHECK(squares({c.centre, c.radius + step}) > least);
  }
  CHECK(fit.n == 40);
  CHECK(fit.sigma == doctest::Approx(std::sqrt(least / 37)).scale(0));  // three unknowns
}

TEST_CASE("fit_circle__robust__leaves_outliers_out_and_limits_decide") {
  std::vector<Vec2> points = arc({{1, -2}, 0.5}, 2 * std::numbers::pi, 200, 0.002);
  for (size_t i = 0; i < points.size(); i += 5) points[i] = points[i] + Vec2{0.3, 0.2};
  Task task;
  CircleFit fit;
  REQUIRE(fit_circle(points, {}, task, fit));
  CHECK(norm(fit.circle.centre - Vec2{1, -2}) < 0.001);
  CHECK(std::fabs(fit.circle.radius - 0.5) < 0.001);
  PrimitiveSetting setting;
  setting.max_radius_m = 0.45;
  CHECK_FALSE(fit_circle(points, setting, task, fit));
}
