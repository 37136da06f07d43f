// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/sphere_target.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/sphere.h"
#include "registration/targets/ray_noise.h"

namespace jalon {

namespace {

constexpr double kSearchRadii = 2.5, kFreeSearch_m = 0.25;
constexpr double kLeastRadius_m = 0.005;
constexpr double kLeastCap_rad =
    40 * std::numbers::pi / 180;     // half-angle of what is seen; a hemisphere has 90
constexpr double kCapShare = 0.9;    // of the points lie within it
constexpr double kMostInside = 0.3;  // points inside the ball, to those on it: something else
constexpr double kMostSigma =
    0.5;  // of the tolerance: as even a distribution as that is no surface
constexpr double kOneSided =
    0.5;  // length of the mean normal: 2 / 3 of a sphere seen from afar, 0 all round
constexpr int kSphereTargetDraws = 3000;
constexpr int kTries = 12;        // for a second and a third point close enough to the first
constexpr size_t kScored = 1024;  // points that a draw is judged by

/// A sphere of a known radius.
struct CentreModel {
  using Point = Vec3;
  static constexpr size_t kUnknowns = 3;
  Sphere sphere;
  double residual(const Vec3& p, Coefficients<3>& j) const {
    const Vec3 d = p - sphere.centre;
    const double r = norm(d);
    const Vec3 u = r > 0 ? d / r : Vec3{0, 0, 1};
    j = {-u.x, -u.y, -u.z};
    return r - sphere.radius;
  }
  void move(const Coefficients<3>& step) { sphere.centre += Vec3{step[0], step[1], step[2]}; }
};

// The two centres of the spheres of this radius through three points; none when the circle through
// them is larger.
std::optional<std::array<Vec3, 2>> centres_through(const Vec3& a, const Vec3& b, const Vec3& c,
                                                   double radius) {
  const Vec3 u = b - a, v = c - a, n = cross(u, v);
  const double n2 = squared_norm(n);
  if (!(n2 > 1e-4 * squared_norm(u) * squared_norm(v))) return std::nullopt;
  const Vec3 to = (squared_norm(u) * cross(v, n) - squared_norm(v) * cross(u, n)) * (0.5 / n2);
  const double height2 = radius * radius - squared_norm(to);
  if (!(height2 >= 0)) return std::nullopt;
  const Vec3 up = n * std::sqrt(height2 / n2);
  return std::array{a + to + up, a + to - up};
}

double score_of(const std::vector<Vec3>& sample, const Sphere& sphere, double tolerance_m) {
  double sum = 0;
  for (const Vec3& p : sample) {
    const double d = std::fabs(sphere.distance(p)) / tolerance_m;
    sum += d < 1 ? 1 - d * d : 0;
  }
  return sum;
}

// A point of the list within reach of another.
std::optional<Vec3> draw_near(const std::vector<Vec3>& points, const Vec3& first, double reach_m,
                              RandomStream& random) {
  for (int i = 0; i < kTries; ++i) {
    const Vec3 drawn = points[random.below(points.size())];
    const double apart2 = squared_norm(drawn - first);
    if (apart2 > 0 && apart2 <= reach_m * reach_m) return drawn;
  }
  return std::nullopt;
}

// Step 1 with a known radius: two spheres to three points that are no further apart than it allows.
std::optional<Sphere> draw_known(const Surroundings& near, const MeasuringSettings& setting,
                                 Task& task) {
  std::vector<Vec3> sample;
  const size_t step = near.points.size() / kScored + 1;
  for (size_t i = 0; i < near.points.size(); i += step) sample.push_back(near.points[i]);
  std::optional<Sphere> best;
  double best_score = 0;
  for (int i = 0; i < kSphereTargetDraws; ++i) {
    if (i % 64 == 0) task.checkpoint(0);
    RandomStream random(setting.seed, static_cast<uint64_t>(i));
    const Vec3 a = near.points[random.below(near.points.size())];
    const auto b = draw_near(near.points, a, 2 * setting.radius_m, random);
    if (!b) continue;
    const auto c = draw_near(near.points, a, 2 * setting.radius_m, random);
    if (!c) continue;
    const auto centres = centres_through(a, *b, *c, setting.radius_m);
    if (!centres) continue;
    for (const Vec3& centre : *centres) {
      const Sphere sphere{centre, setting.radius_m};
      const double score = score_of(sample, sphere, setting.tolerance_m);
      if (score > best_score) best_score = score, best = sphere;
    }
  }
  return best;
}

// Step 1 with any radius.
std::optional<Sphere> draw_free(const Surroundings& near, const PrimitiveSetting& limits,
                                Task& task) {
  SphereFit fit;
  if (!fit_sphere(near.points, limits, task, fit)) return std::nullopt;
  return fit.sphere;
}

PrimitiveSetting free_setting(const MeasuringSettings& setting, double search_m) {
  PrimitiveSetting out;
  out.tolerance_m = setting.tolerance_m;
  out.min_radius_m = kLeastRadius_m;
  out.max_radius_m = search_m;
  out.seed = setting.seed;
  return out;
}

// Step 4: half-angle of the cap that holds most of the points, seen from the centre.
double cap_of(const std::vector<Vec3>& points, const Sphere& sphere, double tolerance_m) {
  Vec3 mean;
  std::vector<double> angles;
  for (const Vec3& p : points)
    if (std::fabs(sphere.distance(p)) <= tolerance_m) mean += normalized(p - sphere.centre);
  mean = normalized(mean);
  for (const Vec3& p : points)
    if (std::fabs(sphere.distance(p)) <= tolerance_m)
      angles.push_back(std::acos(std::clamp(dot(mean, normalized(p - sphere.centre)), -1.0, 1.0)));
  if (angles.empty()) return 0;
  const auto at =
      angles.begin() + static_cast<ptrdiff_t>(kCapShare * static_cast<double>(angles.size() - 1));
  std::nth_element(angles.begin(), at, angles.end());
  return *at;
}

bool is_ball(const std::vector<Vec3>& points, const Sphere& sphere, double tolerance_m) {
  size_t inside = 0, on = 0;
  for (const Vec3& p : points) {
    const double d = sphere.distance(p);
    inside += d < -tolerance_m;
    on += std::fabs(d) <= tolerance_m;
  }
  if (static_cast<double>(inside) > kMostInside * static_cast<double>(on)) return false;
  return cap_of(points, sphere, tolerance_m) >= kLeastCap_rad;
}

// From the points to their scanner; without stations, along the axis of the cap that is seen. Empty for points seen
// from who knows where, as those of a sphere scanned all round.
std::vector<Vec3> rays_of(const Cloud& cloud, const Surroundings& near, const Sphere& sphere) {
  std::vector<Vec3> out;
  Vec3 axis;
  for (const Vec3& p : near.points)
    axis += normalized(p - sphere.centre) / static_cast<double>(near.points.size());
  for (size_t i = 0; i < near.points.size(); ++i) {
    const Station* station = station_of(cloud, near.indices[i]);
    if (station != nullptr && station->has_pose)
      out.push_back(normalized(station->pose.translation() - near.place - near.points[i]));
    else if (norm(axis) > kOneSided) out.push_back(normalized(axis));
    else return {};
  }
  return out;
}

// Steps 3 and 4; none where there is no ball.
std::optional<MeasuredTarget> adjusted(const Cloud& cloud, const Surroundings& near,
                                       const MeasuringSettings& setting,
                                       const PrimitiveSetting& limits, const Sphere& start,
                                       Task& task) {
  MeasuredTarget out;
  const std::vector<Vec3>& points = near.points;
  SphereFit fit;
  if (setting.radius_m > 0) {
    CentreModel model{start};
    Adjusted<3> of;
    if (!adjust(std::span<const Vec3>(points), limits.adjustment(), task, model, of))
      return std::nullopt;
    fit.sphere = model.sphere, fit.n = of.n, fit.sigma = of.sigma;
    out.covariance = of.covariance;
    out.radius_sigma_m = 0;
  } else {
    if (!adjust_sphere(points, start, limits, task, fit)) return std::nullopt;
    for (size_t r = 0; r < 3; ++r)
      for (size_t c = 0; c < 3; ++c) out.covariance[3 * r + c] = fit.covariance[4 * r + c];
    out.radius_sigma_m = std::sqrt(fit.covariance[15]);
  }
  const std::vector<Vec3> rays = rays_of(cloud, near, fit.sphere);
  if (!rays.empty())
    fit.sphere = without_ray_bias(points, rays, fit.sphere, fit.sigma, setting.radius_m > 0);
  out.centre = fit.sphere.centre;
  out.radius_m = fit.sphere.radius;
  out.sigma_m = fit.sigma;
  out.points = fit.n;
  const bool is_good = is_finite(out.centre) && is_ball(points, fit.sphere, setting.tolerance_m) &&
                       fit.sigma <= kMostSigma * setting.tolerance_m;
  if (!is_good) return std::nullopt;
  return out;
}

}  // namespace

MeasuredTarget measure_sphere(const Cloud& cloud, const Octree& tree, const Vec3& place,
                              const MeasuringSettings& setting, Task& task) {
  const bool known = setting.radius_m > 0;
  const double search_m = setting.search_m > 0 ? setting.search_m
                          : known              ? kSearchRadii * setting.radius_m
                                               : kFreeSearch_m;
  const PrimitiveSetting limits = free_setting(setting, search_m);
  const auto refused = [](Status status, size_t points) {
    MeasuredTarget none;
    none.status = status;
    none.points = points;
    return none;
  };
  Surroundings near = surroundings_of(cloud, tree, place, {}, search_m);
  if (near.points.size() < setting.min_points)
    return refused(Status::kInsufficientData, near.points.size());
  const std::optional<Sphere> start =
      known ? draw_known(near, setting, task) : draw_free(near, limits, task);
  if (!start) return refused(Status::kDegenerate, 0);
  // Step 2: the whole of it, and nothing behind it.
  near =
      surroundings_of(cloud, tree, place, start->centre, start->radius + 2 * setting.tolerance_m);
  if (near.points.size() < setting.min_points)
    return refused(Status::kInsufficientData, near.points.size());
  const std::optional<MeasuredTarget> out = adjusted(cloud, near, setting, limits, *start, task);
  if (!out) return refused(Status::kDegenerate, 0);
  if (out->points < setting.min_points) return refused(Status::kInsufficientData, out->points);
  return *out;
}

}  // namespace jalon
