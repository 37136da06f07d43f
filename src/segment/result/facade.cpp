// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/result/facade.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr double kVerticalSine =
    0.1736;  // |nz| of a plane within 10 degrees of the vertical: walls lean
constexpr double kNearFacade_m = 1;  // depth of what tells a facade's back from its front
constexpr double kFoot =
    0.1;  // part of the height left out of that: ground and plants lie in front
constexpr double kSameDirection = 0.985;  // 10 degrees
constexpr size_t kFacadePointsPerChunk = 1 << 15;

struct Sides {
  int64_t front = 0, behind = 0;
  Sides& operator+=(const Sides& b) {
    front += b.front;
    behind += b.behind;
    return *this;
  }
};

// Points in front of and behind a facade, within its outline's box and beyond the tolerance.
Sides count_sides(const FacadeContext& c, const Segment& facade, std::span<const uint32_t> labels,
                  Task& task) {
  struct Extent {
    double low = INFINITY, high = -INFINITY, left = INFINITY, right = -INFINITY;
    Extent& operator+=(const Extent& b) {
      low = std::min(low, b.low);
      high = std::max(high, b.high);
      left = std::min(left, b.left);
      right = std::max(right, b.right);
      return *this;
    }
  };
  const Plane& plane = facade.fit.plane;
  const Vec3 along = normalized(cross({0, 0, 1}, plane.normal));
  const size_t n = c.cloud.size();
  const Extent extent =
      parallel_reduce(task, n, kFacadePointsPerChunk, Extent{}, [&](size_t begin, size_t end) {
        Extent e;
        for (size_t i = begin; i < end; ++i) {
          if (labels[i] != facade.label) continue;
          const Vec3 p = c.cloud.point(i) - c.origin;
          e += Extent{p.z, p.z, dot(p, along), dot(p, along)};
        }
        return e;
      });
  const double low = extent.low + kFoot * (extent.high - extent.low);
  return parallel_reduce(task, n, kFacadePointsPerChunk, Sides{}, [&](size_t begin, size_t end) {
    Sides sides;
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = c.cloud.point(i) - c.origin;
      const double d = plane.distance(p), a = dot(p, along);
      if (std::fabs(d) <= 2 * c.distance_tolerance_m || std::fabs(d) > kNearFacade_m) continue;
      if (p.z < low || p.z > extent.high || a < extent.left || a > extent.right) continue;
      ++(d > 0 ? sides.front : sides.behind);
    }
    return sides;
  });
}

bool has_poses(const Cloud& cloud) {
  return std::any_of(cloud.stations.begin(), cloud.stations.end(),
                     [](const Station& s) { return s.has_pose; });
}

// For each segment: points seen from its front minus those seen from behind.
std::vector<int64_t> station_votes(const FacadeContext& c, std::span<const uint32_t> labels,
                                   const std::vector<Segment>& segments) {
  std::vector<int64_t> votes(segments.size(), 0);
  for (const Station& station : c.cloud.stations) {
    if (!station.has_pose) continue;
    std::vector<int64_t> seen(segments.size(), 0);
    const size_t end = std::min<size_t>(c.cloud.size(), station.first + station.count);
    for (size_t i = station.first; i < end; ++i)
      if (labels[i] != 0) ++seen[labels[i] - 1];
    const Vec3 eye = station.pose.translation() - c.origin;
    for (size_t s = 0; s < segments.size(); ++s)
      if (segments[s].is_plane())
        votes[s] += segments[s].fit.plane.distance(eye) >= 0 ? seen[s] : -seen[s];
  }
  return votes;
}

Vec3 middle_of(const FacadeContext& c, Task& task) {
  const Vec3 sum = parallel_reduce(task, c.cloud.size(), kFacadePointsPerChunk, Vec3{},
                                   [&](size_t begin, size_t end) {
                                     Vec3 part;
                                     for (size_t i = begin; i < end; ++i)
                                       part += c.cloud.point(i) - c.origin;
                                     return part;
                                   });
  return sum / static_cast<double>(c.cloud.size());
}

void turn_without_stations(const FacadeContext& c, std::span<const uint32_t> labels,
                           std::vector<Segment>& segments, Task& task) {
  const int facade = main_facade(segments);
  const Vec3 middle = middle_of(c, task);
  Vec3 front;
  for (Segment& segment : segments) {
    if (!segment.is_plane()) continue;
    const Vec3& n = segment.fit.plane.normal;
    if (std::fabs(n.z) > kSameDirection ? n.z < 0 : segment.fit.plane.distance(middle) < 0)
      turn_over(segment.fit);
  }
  if (facade < 0) return;
  Segment& main = segments[static_cast<size_t>(facade)];
  const Sides sides = count_sides(c, main, labels, task);
  if (sides.front > sides.behind) turn_over(main.fit);
  front = main.fit.plane.normal;
  for (Segment& segment : segments) {
    if (!segment.is_plane()) continue;
    const double cosine = dot(segment.fit.plane.normal, front);
    if (cosine < -kSameDirection &&
        std::fabs(main.fit.plane.distance(segment.fit.centroid)) < kNearFacade_m)
      turn_over(segment.fit);
  }
}

}  // namespace

int main_facade(const std::vector<Segment>& segments) {
  int best = -1;
  double area = 0;
  for (size_t s = 0; s < segments.size(); ++s)
    if (segments[s].is_plane() && std::fabs(segments[s].fit.plane.normal.z) <= kVerticalSine &&
        segments[s].area_m2 > area) {
      best = static_cast<int>(s);
      area = segments[s].area_m2;
    }
  return best;
}

void turn_normals(const FacadeContext& c, std::span<const uint32_t> labels,
                  std::vector<Segment>& segments, Task& task) {
  if (!has_poses(c.cloud)) {
    turn_without_stations(c, labels, segments, task);
    return;
  }
  const std::vector<int64_t> votes = station_votes(c, labels, segments);
  for (size_t s = 0; s < segments.size(); ++s)
    if (votes[s] < 0) turn_over(segments[s].fit);
}

void classify(const FacadeContext& c, std::vector<Segment>& segments) {
  const int facade = main_facade(segments);
  FacadeAxes axes;  // no facade: those of the coordinates
  if (c.axes != nullptr) axes = *c.axes;
  else if (facade >= 0)
    axes = FacadeAxes::of(segments[static_cast<size_t>(facade)].fit.plane.normal);
  for (Segment& segment : segments)
    if (segment.is_plane())
      segment.orientation = axes.classify(segment.fit.plane.normal, c.orientation_tolerance_rad);
}

Transform facade_transform(const FacadeContext& c, const std::vector<Segment>& segments) {
  const int facade = main_facade(segments);
  Transform out;
  if (!c.facade_frame || facade < 0) return out;
  const PlaneFit& fit = segments[static_cast<size_t>(facade)].fit;
  const Vec3 m = normalized({fit.plane.normal.x, fit.plane.normal.y, 0});
  // Rows: X along the facade (to the right for one who looks at it from the station side), Y into it, Z up.
  const Vec3 x{-m.y, m.x, 0}, y{-m.x, -m.y, 0};
  const Vec3 world = fit.centroid + c.origin;
  const Vec3 foot{std::floor(world.x), std::floor(world.y), std::floor(world.z)};
  out.m = {x.x, x.y, 0, -(x.x * foot.x + x.y * foot.y),
           y.x, y.y, 0, -(y.x * foot.x + y.y * foot.y),
           0,   0,   1, -foot.z};
  return out;
}

}  // namespace jalon
