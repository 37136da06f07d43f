// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/cylinder.h"

#include "geometry/circle.h"
#include "geometry/plane.h"

namespace jalon {

namespace {

constexpr double kCylinderParallelSine =
    0.05;  // 3 degrees between two normals: below, their noise sets the axis
constexpr double kLeastCosine =
    0.906;  // 25 degrees between the normals of point and surface (Schnabel et al. 2007)
constexpr int kAttempts = 3;                // one in ten thousand starts leads nowhere
constexpr uint64_t kSeedStep = 0x9E3779B9;  // keeps the draws of the attempts apart
constexpr double kCylinderOpenRadius =
    0.5;  // standard deviation of the radius, relative, of a cylinder that nothing fixes
constexpr double kOpenDirection = 0.5;  // the same of the direction, rad
// Variance h^2 / 12 along the axis of a closed cylinder against r^2 / 2 across it: h = 2 r * 1.5 gives 1.5 to 1.
constexpr double kLeastElongation = 1.5;

struct CylinderModel {
  using Point = Vec3;
  static constexpr size_t kUnknowns =
      5;  ///< shift of the point and of the direction along the two vectors across; radius
  Cylinder cylinder;
  std::array<Vec3, 2> e;

  CylinderModel() : CylinderModel(Cylinder{}) {}
  explicit CylinderModel(const Cylinder& c) : cylinder(c), e(across(c.direction)) {}
  double radius() const { return cylinder.radius; }
  double residual(const Vec3& p, Coefficients<5>& j) const {
    const Vec3 d = p - cylinder.point;
    const double h = dot(d, cylinder.direction), a = dot(d, e[0]), b = dot(d, e[1]);
    const double r = std::sqrt(a * a + b * b);
    const double u = r > 0 ? a / r : 1, v = r > 0 ? b / r : 0;
    j = {-u, -v, -h * u, -h * v, -1};
    return r - cylinder.radius;
  }
  void move(const Coefficients<5>& step) {
    cylinder.point += step[0] * e[0] + step[1] * e[1];
    cylinder.direction = normalized(cylinder.direction + step[2] * e[0] + step[3] * e[1]);
    cylinder.radius += step[4];
    e = across(cylinder.direction);
  }
};

// The start with the point of its axis amid the points, where shift and turn do not depend on each other.
Cylinder centred(std::span<const Vec3> points, Cylinder c) {
  Vec3 mean;
  for (const Vec3& p : points) mean += p - c.point;
  c.point += dot(mean / static_cast<double>(points.size()), c.direction) * c.direction;
  return c;
}

// Moves the point of the axis to mid height of the points within reach; gives back how far.
double to_mid_height(std::span<const Vec3> points, double reach_m, CylinderFit& fit) {
  double low = INFINITY, high = -INFINITY;
  for (const Vec3& p : points) {
    if (std::fabs(fit.cylinder.distance(p)) > reach_m) continue;
    const double h = dot(p - fit.cylinder.point, fit.cylinder.direction);
    low = std::min(low, h);
    high = std::max(high, h);
  }
  if (!(low <= high)) return 0;
  fit.length_m = high - low;
  fit.cylinder.point += (low + high) / 2 * fit.cylinder.direction;
  return (low + high) / 2;
}

// Upward, so that the same cylinder has the same direction however it was found.
void turn_up(Vec3& direction) {
  const double lead = direction.z != 0 ? direction.z : direction.y != 0 ? direction.y : direction.x;
  if (lead < 0) direction = -direction;
}

// Of point (after it moved by `moved_m` along the axis), direction and radius, from that of the five unknowns.
std::array<double, 49> full_covariance(const CylinderModel& model, double moved_m,
                                       const Square<5>& covariance) {
  std::array<double, 35> j{};
  for (size_t k = 0; k < 2; ++k)
    for (size_t i = 0; i < 3; ++i) {
      const double e = model.e[k][static_cast<int>(i)];
      j[5 * i + k] = e;
      j[5 * i + 2 + k] = moved_m * e;
      j[5 * (3 + i) + 2 + k] = e;
    }
  j[5 * 6 + 4] = 1;
  return propagated<7, 5>(j, covariance);
}

// False for a draw of two points with normals that make no cylinder, or one that its own two points contradict.
bool draw_cylinder(std::span<const Vec3> points, std::span<const Vec3> normals,
                   const PrimitiveSetting& setting, RandomStream& random, CylinderModel& model) {
  const size_t i = random.below(points.size()), k = random.below(points.size());
  Cylinder c;
  if (!cylinder_from_normals(points[i], normals[i], points[k], normals[k], c) ||
      !setting.allows(c.radius))
    return false;
  if (std::fabs(c.distance(points[k])) > setting.tolerance_m) return false;
  model = CylinderModel(centred(points, c));
  return true;
}

// Unknown (NaN) normals agree with everything.
bool normal_agrees(const Cylinder& c, const Vec3& p, const Vec3& normal) {
  const Vec3 d = p - c.point;
  const Vec3 out = normalized(d - dot(d, c.direction) * c.direction);
  return !(std::fabs(dot(out, normal)) < kLeastCosine);
}

}  // namespace

std::array<Vec3, 2> across(const Vec3& direction) {
  const Vec3 far = std::fabs(direction.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = normalized(cross(direction, far));
  return {u, cross(direction, u)};
}

bool cylinder_from_normals(const Vec3& p1, const Vec3& n1, const Vec3& p2, const Vec3& n2,
                           Cylinder& out) {
  const Vec3 axis = cross(n1, n2);
  const double sine = norm(axis);
  if (!(sine > kCylinderParallelSine)) return false;
  const Vec3 a = axis / sine, w = p2 - p1;
  // Across the axis: p1 + t n1 = p2 + s n2 (both normals are perpendicular to it).
  const double t = dot(cross(w, n2), a) / sine;
  out.direction = a;
  out.point = p1 + t * n1;
  out.radius = std::fabs(t);
  return std::isfinite(t);
}

bool cylinder_along(const Vec3& direction, std::span<const Vec3> points, Cylinder& out) {
  if (points.size() < 3) return false;
  const auto e = across(direction);
  std::vector<Vec2> uv;
  for (const Vec3& p : points) uv.push_back({dot(p - points[0], e[0]), dot(p - points[0], e[1])});
  Circle circle;
  if (!circle_linear(uv, circle)) return false;
  out = {points[0] + circle.centre.u * e[0] + circle.centre.v * e[1], direction, circle.radius};
  return true;
}

bool axis_from_covariance(std::span<const Vec3> points, Vec3& direction) {
  if (points.size() < 3) return false;
  Moments moments;
  moments.reference = points[0];
  for (const Vec3& p : points) moments.add(p);
  const Eigen3 eigen = symmetric_eigen(moments.covariance());
  if (!(eigen.values[2] > kLeastElongation * eigen.values[1])) return false;
  direction = eigen.vectors[2];
  return true;
}

bool adjust_cylinder(std::span<const Vec3> points, const Cylinder& start,
                     const PrimitiveSetting& setting, Task& task, CylinderFit& out) {
  CylinderModel model(centred(points, start));
  turn_up(model.cylinder.direction);
  model.e = across(model.cylinder.direction);
  Adjusted<5> adjusted;
  if (!adjust(points, setting.adjustment(), task, model, adjusted)) return false;
  CylinderFit fit;
  fit.cylinder = model.cylinder;
  fit.n = adjusted.n;
  fit.sigma = adjusted.sigma;
  const double moved = to_mid_height(points, setting.adjustment().reach_m, fit);
  fit.covariance = full_covariance(model, moved, adjusted.covariance);
  const double r = fit.cylinder.radius,
               turn = std::max(adjusted.covariance[12], adjusted.covariance[18]);
  if (!is_finite(fit.cylinder.point) || !setting.allows(r)) return false;
  if (fit.covariance[48] > kCylinderOpenRadius * kCylinderOpenRadius * r * r ||
      turn > kOpenDirection * kOpenDirection)
    return false;
  out = fit;
  return true;
}

bool fit_cylinder(std::span<const Vec3> points, std::span<const Vec3> normals,
                  const PrimitiveSetting& setting, Task& task, CylinderFit& out) {
  if (points.size() < 5) return false;
  for (int attempt = 0; attempt < kAttempts && !normals.empty(); ++attempt) {
    PrimitiveSetting anew = setting;
    anew.seed += static_cast<uint64_t>(attempt) * kSeedStep;
    CylinderModel start;
    const auto draw = [&](RandomStream& random, CylinderModel& model) {
      return draw_cylinder(points, normals, anew, random, model);
    };
    const auto agrees = [&](const CylinderModel& model, size_t i) {
      return normal_agrees(model.cylinder, points[i], normals[i]);
    };
    if (best_draw(points, anew, 2, task, draw, agrees, start) &&
        adjust_cylinder(points, start.cylinder, anew, task, out))
      return true;
  }
  if (!normals.empty()) return false;
  Vec3 direction;
  CylinderFit start;
  if (!axis_from_covariance(points, direction)) return false;
  if (!fit_cylinder_along(direction, points, setting, task, start)) return false;
  return adjust_cylinder(points, start.cylinder, setting, task, out);
}

bool fit_cylinder_along(const Vec3& direction, std::span<const Vec3> points,
                        const PrimitiveSetting& setting, Task& task, CylinderFit& out) {
  if (points.size() < 3) return false;
  CylinderModel model(Cylinder{points[0], direction, 0});
  turn_up(model.cylinder.direction);
  model.e = across(model.cylinder.direction);
  std::vector<Vec2> uv(points.size());
  for (size_t i = 0; i < uv.size(); ++i) {
    const Vec3 d = points[i] - points[0];
    uv[i] = {dot(d, model.e[0]), dot(d, model.e[1])};
  }
  CircleFit circle;
  if (!fit_circle(uv, setting, task, circle)) return false;
  Square<5> covariance{};
  constexpr size_t kAt[3] = {0, 1, 4};
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 3; ++c) covariance[5 * kAt[r] + kAt[c]] = circle.covariance[3 * r + c];
  CylinderFit fit;
  fit.cylinder = model.cylinder;
  fit.cylinder.point =
      points[0] + circle.circle.centre.u * model.e[0] + circle.circle.centre.v * model.e[1];
  fit.cylinder.radius = circle.circle.radius;
  fit.n = circle.n;
  fit.sigma = circle.sigma;
  to_mid_height(points, setting.adjustment().reach_m, fit);
  fit.covariance = full_covariance(model, 0, covariance);
  out = fit;
  return true;
}

}  // namespace jalon
