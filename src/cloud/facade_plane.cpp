// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/facade_plane.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/random.h"
#include "cloud/statistics.h"

namespace jalon {

namespace {

/// Points on which hypotheses are counted: the standard error of a share is then below 0.4 %.
constexpr size_t kSample = 20000;
/// Two points and the vertical make a hypothesis; a facade that holds 10 % of the points is drawn
/// with probability 1 - (1 - 0.01)^1000 > 0.9999.
constexpr size_t kDraws = 1000;
constexpr size_t kRefinements = 5;
/// Two drawn points must lie at least this many tolerances apart in plan, or the direction is noise.
constexpr double kMinBase = 10;
/// Streams of the seed.
constexpr uint64_t kSampleStream = 1, kDrawStream = 2, kGroundStream = 1u << 20;
constexpr double kMaxGroundSlope = 0.1736;  // sin 10 degrees
/// The ground is sought among this share of the sample, the lowest.
constexpr double kLowestShare = 0.5;
/// It must hold at least this share of them.
constexpr double kMinGroundShare = 0.05;

std::vector<Vec3> draw_sample(const Cloud& cloud, const Vec3& origin, uint64_t seed) {
  std::vector<Vec3> sample(std::min(kSample, cloud.size()));
  RandomStream random(seed, kSampleStream);
  for (size_t i = 0; i < sample.size(); ++i)
    sample[i] = cloud.point(cloud.size() <= kSample ? i : random.below(cloud.size())) - origin;
  return sample;
}

struct Hypothesis {
  Plane plane;
  size_t inliers = 0;
};

size_t count_inliers(const std::vector<Vec3>& sample, const Plane& plane, double tolerance_m) {
  size_t n = 0;
  for (const Vec3& p : sample) n += std::fabs(plane.distance(p)) <= tolerance_m;
  return n;
}

/// The best of many draws; make(stream, plane) makes the hypothesis of one, or fails. Ties go to
/// the earlier draw.
template <class F>
Hypothesis best_of_draws(const std::vector<Vec3>& sample, double tolerance_m, Task& task,
                         F&& make) {
  std::vector<Hypothesis> tried(kDraws);
  constexpr size_t kDrawsPerChunk = 16;
  parallel_for(task, kDraws, kDrawsPerChunk, [&](size_t begin, size_t end) {
    for (size_t d = begin; d < end; ++d)
      if (make(d, tried[d].plane))
        tried[d].inliers = count_inliers(sample, tried[d].plane, tolerance_m);
  });
  return *std::max_element(
      tried.begin(), tried.end(),
      [](const Hypothesis& a, const Hypothesis& b) { return a.inliers < b.inliers; });
}

/// Least squares on the inliers, again and again, while the plane keeps to the rule.
template <class F>
Plane refined(const std::vector<Vec3>& sample, Plane plane, double tolerance_m, F&& is_allowed) {
  for (size_t round = 0; round < kRefinements; ++round) {
    Moments moments;
    moments.reference = sample.front();
    for (const Vec3& p : sample)
      if (std::fabs(plane.distance(p)) <= tolerance_m) moments.add(p);
    PlaneFit fit;
    if (!fit_plane(moments, fit) || !is_allowed(fit.plane)) return plane;
    plane = fit.plane;
  }
  return plane;
}

/// Turns the plane's positive side to the scanner: to the viewpoint, or to where more points lie
/// outside the layer (the ground and the obstacles before a facade outnumber what is seen through
/// its windows).
void face_the_scanner(const std::vector<Vec3>& sample, const Viewpoint& viewpoint,
                      const Vec3& origin, double tolerance_m, Plane& plane) {
  double side = 0;
  if (viewpoint.known) {
    side = plane.distance(viewpoint.position - origin);
  } else {
    for (const Vec3& p : sample) {
      const double s = plane.distance(p);
      if (std::fabs(s) > tolerance_m) side += s > 0 ? 1 : -1;
    }
  }
  if (side < 0) plane = {-plane.normal, -plane.offset};
}

/// The lowest points, in which a ground need not outnumber all else.
std::vector<Vec3> lowest_of(std::vector<Vec3> points) {
  const auto middle = points.begin() +
                      static_cast<ptrdiff_t>(kLowestShare * static_cast<double>(points.size() - 1));
  std::nth_element(points.begin(), middle, points.end(),
                   [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
  const double limit = middle->z;
  std::erase_if(points, [&](const Vec3& p) { return p.z > limit; });
  return points;
}

}  // namespace

FacadePlane find_facade_plane(const Cloud& cloud, double tolerance_m, double vertical_tolerance_rad,
                              const Viewpoint& viewpoint, uint64_t seed, Task& task) {
  if (cloud.size() < 3)
    fail(Status::kInsufficientData, "%zu points; a facade needs at least 3", cloud.size());
  FacadePlane out;
  out.origin = local_origin(cloud, task);
  const std::vector<Vec3> sample = draw_sample(cloud, out.origin, seed);
  const Hypothesis best = best_of_draws(sample, tolerance_m, task, [&](size_t d, Plane& plane) {
    RandomStream random(seed, kDrawStream + d);
    const Vec3 &a = sample[random.below(sample.size())], &b = sample[random.below(sample.size())];
    const Vec3 normal = cross({b.x - a.x, b.y - a.y, 0}, {0, 0, 1});
    if (norm(normal) < kMinBase * tolerance_m) return false;
    plane.normal = normalized(normal);
    plane.offset = dot(plane.normal, a);
    return true;
  });
  if (best.inliers < 3)
    fail(Status::kDegenerate, "no vertical plane: the points have too little extent in plan");
  const double max_lean = std::sin(vertical_tolerance_rad);
  out.plane = refined(sample, best.plane, tolerance_m,
                      [&](const Plane& plane) { return std::fabs(plane.normal.z) <= max_lean; });
  face_the_scanner(sample, viewpoint, out.origin, tolerance_m, out.plane);
  out.along = normalized(cross({0, 0, 1}, out.plane.normal));
  out.up = cross(out.plane.normal, out.along);
  return out;
}

bool find_ground(const Cloud& cloud, const FacadePlane& facade, double tolerance_m, uint64_t seed,
                 Task& task, GroundPlane& out) {
  std::vector<Vec3> off = draw_sample(cloud, facade.origin, seed);
  std::erase_if(off,
                [&](const Vec3& p) { return std::fabs(facade.plane.distance(p)) <= tolerance_m; });
  if (off.size() < 3) return false;
  const std::vector<Vec3> low = lowest_of(off);
  const auto is_level = [](const Plane& plane) {
    return plane.normal.x * plane.normal.x + plane.normal.y * plane.normal.y <=
           kMaxGroundSlope * kMaxGroundSlope;
  };
  const Hypothesis best = best_of_draws(low, tolerance_m, task, [&](size_t d, Plane& plane) {
    RandomStream random(seed, kGroundStream + d);
    const Vec3 &a = low[random.below(low.size())], &b = low[random.below(low.size())];
    const Vec3& c = low[random.below(low.size())];
    return plane_through(a, b, c, plane) && is_level(plane);
  });
  const double fewest = std::max(3.0, kMinGroundShare * static_cast<double>(low.size()));
  if (static_cast<double>(best.inliers) < fewest) return false;
  // By all points near it: where the ground is most of what is off the facade, the lowest half of
  // those is the lower side of its noise.
  out.plane = refined(off, best.plane, tolerance_m, is_level);
  if (out.plane.normal.z < 0) out.plane = {-out.plane.normal, -out.plane.offset};
  return true;
}

}  // namespace jalon
