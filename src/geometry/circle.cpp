// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/circle.h"

namespace jalon {

namespace {

constexpr double kCircleOpenRadius =
    0.5;  // standard deviation of the radius, relative, of a circle that nothing fixes
constexpr double kStraight = 1e-3;  // sine of the angle of three points in a draw

struct CircleModel {
  using Point = Vec2;
  static constexpr size_t kUnknowns = 3;
  Circle circle;

  double radius() const { return circle.radius; }
  double residual(const Vec2& p, Coefficients<3>& j) const {
    const Vec2 d = p - circle.centre;
    const double r = norm(d);
    const Vec2 u = r > 0 ? d * (1 / r) : Vec2{1, 0};
    j = {-u.u, -u.v, -1};
    return r - circle.radius;
  }
  void move(const Coefficients<3>& step) {
    circle.centre = circle.centre + Vec2{step[0], step[1]};
    circle.radius += step[2];
  }
};

}  // namespace

bool circle_linear(std::span<const Vec2> points, Circle& out) {
  if (points.size() < 3) return false;
  Vec2 mean;
  for (const Vec2& p : points) mean = mean + (p - points[0]);
  mean = points[0] + mean * (1 / static_cast<double>(points.size()));
  Square<3> normal{};
  Coefficients<3> right{};
  for (const Vec2& p : points) {
    const Vec2 d = p - mean;
    const Coefficients<3> row{1, 2 * d.u, 2 * d.v};
    for (size_t r = 0; r < 3; ++r) {
      right[r] += row[r] * dot(d, d);
      for (size_t c = 0; c < 3; ++c) normal[3 * r + c] += row[r] * row[c];
    }
  }
  Cholesky<3> factor;
  if (!factor.factor(normal)) return false;
  const Coefficients<3> x = factor.solve(right);
  const Vec2 centre{x[1], x[2]};
  const double squared = x[0] + dot(centre, centre);
  if (!(squared > 0)) return false;
  out = {mean + centre, std::sqrt(squared)};
  return true;
}

bool fit_circle(std::span<const Vec2> points, const PrimitiveSetting& setting, Task& task,
                CircleFit& out) {
  if (points.size() < 3) return false;
  CircleModel model;
  if (setting.robust && points.size() > 3) {
    const auto draw = [&](RandomStream& random, CircleModel& drawn) {
      std::array<Vec2, 3> three;
      for (Vec2& p : three) p = points[random.below(points.size())];
      const Vec2 a = three[1] - three[0], b = three[2] - three[0];
      if (!(std::fabs(cross(a, b)) > kStraight * norm(a) * norm(b))) return false;
      return circle_linear(three, drawn.circle) && setting.allows(drawn.circle.radius);
    };
    if (!best_draw(points, setting, 3, task, draw, AlwaysAgrees{}, model)) return false;
  } else if (!circle_linear(points, model.circle)) {
    return false;
  }
  Adjusted<3> adjusted;
  if (!adjust(points, setting.adjustment(), task, model, adjusted)) return false;
  const CircleFit fit{model.circle, adjusted.n, adjusted.sigma, adjusted.covariance};
  const double r = fit.circle.radius;
  if (!setting.allows(r) || fit.covariance[8] > kCircleOpenRadius * kCircleOpenRadius * r * r)
    return false;
  out = fit;
  return true;
}

}  // namespace jalon
