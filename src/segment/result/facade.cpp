// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/result/facade.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "segment/front/fronts.h"

namespace jalon {

namespace {

constexpr size_t kFacadePointsPerChunk = 1 << 15;

bool has_poses(const Cloud& cloud) {
  return std::any_of(cloud.stations.begin(), cloud.stations.end(),
                     [](const Station& s) { return s.has_pose; });
}

struct Votes {
  uint64_t before = 0, behind = 0;  ///< points seen from there
};

std::vector<Votes> station_votes(const FacadeContext& c, std::span<const uint32_t> labels,
                                 const std::vector<Segment>& segments) {
  std::vector<Votes> votes(segments.size());
  for (const Station& station : c.cloud.stations) {
    if (!station.has_pose) continue;
    std::vector<uint64_t> seen(segments.size(), 0);
    const size_t end = std::min<size_t>(c.cloud.size(), station.first + station.count);
    for (size_t i = station.first; i < end; ++i)
      if (labels[i] != 0) ++seen[labels[i] - 1];
    const Vec3 eye = station.pose.translation() - c.origin;
    for (size_t s = 0; s < segments.size(); ++s)
      if (segments[s].is_plane())
        (segments[s].fit.plane.distance(eye) >= 0 ? votes[s].before : votes[s].behind) += seen[s];
  }
  return votes;
}

void turn_by_stations(const FacadeContext& c, std::span<const uint32_t> labels,
                      std::vector<Segment>& segments) {
  const std::vector<Votes> votes = station_votes(c, labels, segments);
  for (size_t s = 0; s < segments.size(); ++s) {
    const auto [before, behind] = votes[s];
    if (before + behind == 0) continue;
    if (behind > before) turn_over(segments[s].fit);
    segments[s].front_source = FrontSource::kStation;
    segments[s].front_confidence =
        static_cast<double>(std::max(before, behind)) / static_cast<double>(before + behind);
  }
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

// The wall's planes and those that belong to it.
void turn_wall(const WallFront& front, std::vector<Segment>& segments) {
  const Vec3 normal = segments[front.group.main].fit.plane.normal;
  const Vec3 outward = front.is_before() ? normal : -normal;
  for (const auto* planes : {&front.group.members, &front.group.attendants})
    for (const size_t s : *planes) {
      Segment& segment = segments[s];
      if (dot(segment.fit.plane.normal, outward) < 0) turn_over(segment.fit);
      segment.front_source = FrontSource::kEvidence;
      segment.front_confidence = front.confidence();
    }
}

void turn_by_evidence(const FacadeContext& c, std::span<const uint32_t> labels,
                      std::vector<Segment>& segments, Task& task) {
  const std::vector<WallFront> fronts = wall_fronts(c.cloud, c.origin, labels, segments, task);
  const Vec3 middle = fronts.empty() ? middle_of(c, task) : Vec3{};
  for (const WallFront& front : fronts) turn_wall(front, segments);
  const auto viewer_of = [&](const Segment& segment) {
    const auto distance = [&](const WallFront& front) {
      return norm(segments[front.group.main].fit.centroid - segment.fit.centroid);
    };
    return std::min_element(
               fronts.begin(), fronts.end(),
               [&](const WallFront& a, const WallFront& b) { return distance(a) < distance(b); })
        ->viewer;
  };
  for (Segment& segment : segments) {
    if (!segment.has_plane() || segment.front_source != FrontSource::kNone) continue;
    const Plane& plane = segment.fit.plane;
    if (std::fabs(plane.normal.z) > kSameDirection
            ? plane.normal.z < 0
            : plane.distance(fronts.empty() ? middle : viewer_of(segment)) < 0)
      turn_over(segment.fit);
  }
}

}  // namespace

int main_facade(const std::vector<Segment>& segments) {
  int best = -1;
  double area = 0;
  for (size_t s = 0; s < segments.size(); ++s)
    if (is_upright(segments[s]) && segments[s].area_m2 > area) {
      best = static_cast<int>(s);
      area = segments[s].area_m2;
    }
  return best;
}

void turn_normals(const FacadeContext& c, std::span<const uint32_t> labels,
                  std::vector<Segment>& segments, Task& task) {
  if (has_poses(c.cloud)) turn_by_stations(c, labels, segments);
  else turn_by_evidence(c, labels, segments, task);
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
