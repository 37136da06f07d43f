// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ransac/curved_checks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/symmetric_eigen.h"
#include "segment/ransac/curved_hypotheses.h"

namespace jalon {

namespace {

constexpr double kCurvedChecksLeastGain = 2;  // rms about the best plane against the own sigma
// A bar has four faces, and five where the map is cut amid one; octagons count as round.
constexpr size_t kMostFacets = 5;
constexpr size_t kArcs = 24;  // places along the arc where an edge may be
constexpr double kMostBeside =
    0.5;  // points beside the surface against those on it; clutter has as many

// Angle over which the normals of the surface's points spread.
double turn_rad(const Curved& curved, std::span<const Vec3> points, Task& task) {
  const SurfaceMap map = curved.map(points, task);
  double low = INFINITY, high = -INFINITY, farthest = 0;
  for (const Vec3& p : points) {
    const Vec2 q = map(p);
    low = std::min(low, q.u);
    high = std::max(high, q.u);
    farthest = std::max(farthest, norm(q));
  }
  if (!curved.is_sphere()) return (high - low) / curved.radius;
  return 4 * std::asin(std::min(
                 1.0, farthest / (2 * curved.radius)));  // on Lambert's map 2 r sin(angle / 2)
}

// Sum of the squared distances of points from their least-squares plane.
double squares_about_plane(const Moments& moments) {
  if (moments.n < 4) return 0;
  return std::max(0.0, symmetric_eigen(moments.covariance()).values[0]) *
         static_cast<double>(moments.n);
}

// Sums of the points by their place along the arc, and the sum of their squared distances from the surface.
std::array<Moments, kArcs> moments_of_arcs(const Surface& surface, std::span<const Vec3> points,
                                           double& squares, Task& task) {
  const SurfaceMap map = surface.curved.map(points, task);
  std::vector<double> u(points.size());
  std::transform(points.begin(), points.end(), u.begin(), [&](const Vec3& p) { return map(p).u; });
  const auto [low, high] = std::minmax_element(u.begin(), u.end());
  const double step = std::max(*high - *low, 1e-9) / kArcs;
  std::array<Moments, kArcs> arcs;
  for (Moments& m : arcs) m.reference = points[0];
  for (size_t i = 0; i < points.size(); ++i) {
    arcs[std::min(kArcs - 1, static_cast<size_t>((u[i] - *low) / step))].add(points[i]);
    squares += surface.curved.distance(points[i]) * surface.curved.distance(points[i]);
  }
  return arcs;
}

}  // namespace

bool bends(const SurfaceSettings& settings, const Surface& surface, std::span<const Vec3> points,
           Task& task) {
  if (turn_rad(surface.curved, points, task) < 2 * settings.normal_tolerance_rad) return false;
  PlaneFit plane;
  return fit_plane(points, plane) && plane.sigma >= kCurvedChecksLeastGain * surface.sigma_m;
}

// Least sum of squares of one plane, two, three ... over consecutive arcs, by dynamic programming over their ends.
bool is_faceted(const Surface& surface, std::span<const Vec3> points, Task& task) {
  if (surface.curved.is_sphere()) return false;
  double squares = 0;
  const std::array<Moments, kArcs> arcs = moments_of_arcs(surface, points, squares, task);
  std::array<double, kArcs + 1> least;  // of the arcs before k
  least.fill(INFINITY);
  least[0] = 0;
  for (size_t facets = 1; facets <= kMostFacets; ++facets) {
    std::array<double, kArcs + 1> next;
    next.fill(INFINITY);
    for (size_t first = 0; first < kArcs; ++first) {
      if (!(least[first] <= squares)) continue;
      Moments sum = arcs[first];
      for (size_t end = first + 1; end <= kArcs; ++end) {
        next[end] = std::min(next[end], least[first] + squares_about_plane(sum));
        if (end < kArcs) sum += arcs[end];
      }
    }
    least = next;
    if (least[kArcs] <= squares) return true;
  }
  return false;
}

bool stands_out(const SegmentScene& scene, const PointPool& pool, const Surface& surface,
                std::span<const Vec3> points, Task& task) {
  const double tolerance = scene.settings.distance_tolerance_m;
  const SurfaceMap map = surface.curved.map(points, task);
  std::vector<Vec2> uv(points.size());
  std::transform(points.begin(), points.end(), uv.begin(), [&](const Vec3& p) { return map(p); });
  const Raster raster = bounded_raster(uv, surface.pixel_m, 0, task);
  CurvedTest test = curved_test(scene, surface.curved, 0, 2 * tolerance);
  test.cosine2 = 0;
  size_t beside = 0;
  for (const uint32_t slot : pool.collect(test, task)) {
    const Vec3 p = pool.point(slot);
    if (std::fabs(surface.curved.distance(p)) <= tolerance) continue;
    beside += raster.holds(map(p));
  }
  return static_cast<double>(beside) <= kMostBeside * static_cast<double>(points.size());
}

bool better_as_cylinder(const Surface& sphere, std::span<const Vec3> points,
                        const PrimitiveSetting& setting, Task& task, Curved& out) {
  Moments normals;  // those of a cylinder are all across its axis
  for (const Vec3& p : points) normals.add(normalized(sphere.curved.outward(p)));
  const Eigen3 spread = symmetric_eigen(normals.products);
  Segment fitted;
  const Curved start(Cylinder{sphere.curved.centre, spread.vectors[0], sphere.curved.radius});
  if (!adjust_curved(points, start, setting, task, fitted) || fitted.sigma_m() >= sphere.sigma_m)
    return false;
  out = curved_of(fitted);
  return true;
}

}  // namespace jalon
