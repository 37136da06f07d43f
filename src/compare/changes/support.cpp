// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/support.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace jalon {

namespace {

constexpr int kDraws = 300;          // 99.9 % sure of a plane that holds 30 % of the points
constexpr size_t kSample = 4000;     // points that draws are counted on
constexpr size_t kMostSupports = 4;  // floor and the walls of a corner
constexpr double kLeastShare = 0.1;  // of the unchanged points
constexpr size_t kLeastPoints = 50;
constexpr double kSigmas = 4;    // half-thickness in standard deviations of the plane's points
constexpr double kBeyond = 0.5;  // share of its points outside the change's box
constexpr double kReach = 1.25;  // its extents over those of the change along its own axes

bool best_draw(const std::vector<Vec3>& points, double tolerance_m, RandomStream& random,
               Plane& best) {
  size_t most = 0;
  for (int k = 0; k < kDraws; ++k) {
    const Vec3& a = points[random.below(points.size())];
    const Vec3& b = points[random.below(points.size())];
    const Vec3& c = points[random.below(points.size())];
    Plane plane;
    if (!plane_through(a, b, c, plane)) continue;
    const auto n =
        static_cast<size_t>(std::count_if(points.begin(), points.end(), [&](const Vec3& p) {
          return std::abs(plane.distance(p)) <= tolerance_m;
        }));
    if (n <= most) continue;
    most = n;
    best = plane;
  }
  return most >= 3;
}

// Extent of points along a direction.
double extent(std::span<const Vec3> points, const Vec3& direction) {
  double low = INFINITY, high = -INFINITY;
  for (const Vec3& p : points) {
    low = std::min(low, dot(p, direction));
    high = std::max(high, dot(p, direction));
  }
  return high - low;
}

double extent(const Box3& box, const Vec3& direction) {
  const Vec3 size = box.max - box.min;
  return std::abs(size.x * direction.x) + std::abs(size.y * direction.y) +
         std::abs(size.z * direction.z);
}

bool lies_outside(std::span<const Vec3> inliers, const Box3& change) {
  const auto outside = static_cast<double>(std::count_if(
      inliers.begin(), inliers.end(), [&](const Vec3& p) { return !change.contains(p); }));
  return outside >= kBeyond * static_cast<double>(inliers.size());
}

Support support_of(const PlaneFit& fit, std::span<const Vec3> inliers, double tolerance_m) {
  return {fit.plane,
          std::clamp(kSigmas * fit.sigma, 0.2 * tolerance_m, tolerance_m),
          fit.axis_u,
          fit.axis_v,
          extent(inliers, fit.axis_u),
          extent(inliers, fit.axis_v)};
}

}  // namespace

bool Support::goes_beyond(const Box3& thing) const {
  return width_u_m >= kReach * extent(thing, axis_u) && width_v_m >= kReach * extent(thing, axis_v);
}

size_t support_step(size_t unchanged) { return unchanged / kSample + 1; }

std::vector<Support> find_supports(std::span<const Vec3> unchanged, const Box3& change,
                                   double tolerance_m, uint64_t seed) {
  std::vector<Support> out;
  std::vector<Vec3> rest(unchanged.begin(), unchanged.end());
  const auto least =
      std::max(kLeastPoints, static_cast<size_t>(kLeastShare * static_cast<double>(rest.size())));
  RandomStream random(seed, 0);
  while (out.size() < kMostSupports && rest.size() >= least) {
    Plane plane;
    if (!best_draw(rest, tolerance_m, random, plane)) break;
    const auto split = std::stable_partition(rest.begin(), rest.end(), [&](const Vec3& p) {
      return std::abs(plane.distance(p)) > tolerance_m;
    });
    const std::span<const Vec3> inliers(split, rest.end());
    PlaneFit fit;
    if (inliers.size() < least || !fit_plane(inliers, fit)) break;
    const Support found = support_of(fit, inliers, tolerance_m);
    if (lies_outside(inliers, change) && found.goes_beyond(change)) out.push_back(found);
    rest.erase(split, rest.end());
  }
  return out;
}

}  // namespace jalon
