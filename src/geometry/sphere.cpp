// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/sphere.h"

#include "geometry/plane.h"

namespace jalon {

namespace {

constexpr double kFlat =
    1e-6;  // smallest against largest extent of four points, of a thousandth each side
constexpr double kSphereParallelSine =
    0.05;  // 3 degrees between two normals: below, noise of the normals sets the centre
constexpr double kSphereOpenRadius =
    0.5;  // standard deviation of the radius, relative, of a sphere that nothing fixes

struct SphereModel {
  using Point = Vec3;
  static constexpr size_t kUnknowns = 4;
  Sphere sphere;

  double radius() const { return sphere.radius; }
  /// Rows of Boulaassal 2010, E.11.
  double residual(const Vec3& p, Coefficients<4>& j) const {
    const Vec3 d = p - sphere.centre;
    const double r = norm(d);
    const Vec3 u = r > 0 ? d / r : Vec3{0, 0, 1};
    j = {-u.x, -u.y, -u.z, -1};
    return r - sphere.radius;
  }
  void move(const Coefficients<4>& step) {
    sphere.centre += Vec3{step[0], step[1], step[2]};
    sphere.radius += step[3];
  }
};

bool usable(const SphereFit& fit, const PrimitiveSetting& setting) {
  if (!is_finite(fit.sphere.centre) || !setting.allows(fit.sphere.radius)) return false;
  const double variance = fit.covariance[15];
  return !(variance > kSphereOpenRadius * kSphereOpenRadius * fit.sphere.radius *
                          fit.sphere.radius);  // NaN: four points
}

}  // namespace

bool sphere_through(const std::array<Vec3, 4>& points, Sphere& out) {
  Moments moments;
  moments.reference = points[0];
  for (const Vec3& p : points) moments.add(p);
  const Eigen3 eigen = symmetric_eigen(moments.covariance());
  if (!(eigen.values[0] > kFlat * eigen.values[2])) return false;
  Square<3> normal{};
  Coefficients<3> right{};
  for (size_t i = 0; i < 4; ++i) {  // planes that halve P1P2, P2P3, P3P4, P4P1
    const Vec3 a = points[i] - points[0], b = points[(i + 1) % 4] - points[0], n = b - a;
    const double offset = dot(n, a + b) / 2;
    for (int r = 0; r < 3; ++r) {
      right[static_cast<size_t>(r)] += n[r] * offset;
      for (int c = 0; c < 3; ++c) normal[static_cast<size_t>(3 * r + c)] += n[r] * n[c];
    }
  }
  Cholesky<3> factor;
  if (!factor.factor(normal)) return false;
  const Coefficients<3> centre = factor.solve(right);
  out.centre = points[0] + Vec3{centre[0], centre[1], centre[2]};
  out.radius = norm(out.centre - points[0]);
  return std::isfinite(out.radius);
}

bool sphere_linear(std::span<const Vec3> points, Sphere& out) {
  if (points.size() < 4) return false;
  Vec3 mean;
  for (const Vec3& p : points) mean += p - points[0];
  mean = points[0] + mean / static_cast<double>(points.size());
  Square<4> normal{};
  Coefficients<4> right{};
  for (const Vec3& p : points) {
    const Vec3 d = p - mean;
    const Coefficients<4> row{1, 2 * d.x, 2 * d.y, 2 * d.z};
    for (size_t r = 0; r < 4; ++r) {
      right[r] += row[r] * squared_norm(d);
      for (size_t c = 0; c < 4; ++c) normal[4 * r + c] += row[r] * row[c];
    }
  }
  Cholesky<4> factor;
  if (!factor.factor(normal)) return false;
  const Coefficients<4> x = factor.solve(right);
  const Vec3 centre{x[1], x[2], x[3]};
  const double squared = x[0] + squared_norm(centre);
  if (!(squared > 0)) return false;
  out = {mean + centre, std::sqrt(squared)};
  return true;
}

bool sphere_from_normals(const Vec3& p1, const Vec3& n1, const Vec3& p2, const Vec3& n2,
                         Sphere& out) {
  const double b = dot(n1, n2), sine2 = 1 - b * b;
  if (!(sine2 > kSphereParallelSine * kSphereParallelSine)) return false;
  const Vec3 w = p1 - p2;
  const double d = dot(n1, w), e = dot(n2, w);
  const double t1 = (b * e - d) / sine2, t2 = (e - b * d) / sine2;
  out.centre = 0.5 * (p1 + t1 * n1 + p2 + t2 * n2);
  out.radius = 0.5 * (norm(out.centre - p1) + norm(out.centre - p2));
  return out.radius > 0;
}

bool adjust_sphere(std::span<const Vec3> points, const Sphere& start,
                   const PrimitiveSetting& setting, Task& task, SphereFit& out) {
  SphereModel model{start};
  Adjusted<4> adjusted;
  if (!adjust(points, setting.adjustment(), task, model, adjusted)) return false;
  const SphereFit fit{model.sphere, adjusted.n, adjusted.sigma, adjusted.covariance};
  if (!usable(fit, setting)) return false;
  out = fit;
  return true;
}

bool fit_sphere(std::span<const Vec3> points, const PrimitiveSetting& setting, Task& task,
                SphereFit& out) {
  if (points.size() < 4) return false;
  SphereModel start;
  if (setting.robust && points.size() > 4) {
    const auto draw = [&](RandomStream& random, SphereModel& model) {
      std::array<Vec3, 4> four;
      for (Vec3& p : four) p = points[random.below(points.size())];
      return sphere_through(four, model.sphere) && setting.allows(model.sphere.radius);
    };
    if (!best_draw(points, setting, 4, task, draw, AlwaysAgrees{}, start)) return false;
  } else if (!sphere_linear(points, start.sphere)) {
    return false;
  }
  return adjust_sphere(points, start.sphere, setting, task, out);
}

}  // namespace jalon
