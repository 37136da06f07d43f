// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/walls.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "segment/upright.h"

namespace jalon {

namespace {

// Of a wall that is judged by itself; as the modeller takes a facade's main wall.
constexpr double kLeastWall_m2 = 4, kLeastShare = 0.05, kLeastHeight_m = 2;
constexpr double kOnePlane_m = 0.06;  // pieces of a wall between bands, and their bulges
constexpr double kBeside_m = 3;       // gap between pieces of a group: a gateway, a gutter, a tree
constexpr double kNearWall_m = 2.5;   // before or behind it: panes, set-backs, balconies

struct Extent {
  double low = 0, high = 0;
};

// Of a segment along a direction, by its own axes.
Extent extent_along(const Segment& s, const Vec3& direction) {
  const double middle = dot(s.fit.centroid, direction);
  const double half = 0.5 * (std::fabs(dot(s.fit.axis_u, direction)) * s.length_u_m +
                             std::fabs(dot(s.fit.axis_v, direction)) * s.length_v_m);
  return {middle - half, middle + half};
}

double height_of(const Segment& s) {
  const Extent e = extent_along(s, {0, 0, 1});
  return e.high - e.low;
}

class Grouping {
 public:
  explicit Grouping(const std::vector<Segment>& segments) : segments_(segments) {}

  void add(size_t s) {
    const Segment& segment = segments_[s];
    if (groups_.empty()) largest_m2_ = segment.area_m2;
    const bool is_wall = segment.area_m2 >= std::max(kLeastWall_m2, kLeastShare * largest_m2_) &&
                         height_of(segment) >= kLeastHeight_m;
    size_t first = groups_.size();
    for (size_t g = 0; g < groups_.size(); ++g) {
      const double off_m = distance_from(g, segment);
      if (off_m > kNearWall_m) continue;
      first = std::min(first, g);
      if (off_m > kOnePlane_m) continue;
      groups_[g].members.push_back(s);
      const Extent e = extent_along(segment, along_[g]);
      extents_[g] = {std::min(extents_[g].low, e.low), std::max(extents_[g].high, e.high)};
      return;
    }
    if (is_wall) {
      groups_.push_back({s, {s}, {}});
      along_.push_back(normalized(cross({0, 0, 1}, segment.fit.plane.normal)));
      extents_.push_back(extent_along(segment, along_.back()));
    } else if (first < groups_.size()) {
      groups_[first].attendants.push_back(s);
    }
  }
  std::vector<WallGroup> take() { return std::move(groups_); }

 private:
  // Out of a group's plane; infinity for what is not parallel to it or not beside it.
  double distance_from(size_t g, const Segment& segment) const {
    const Plane& plane = segments_[groups_[g].main].fit.plane;
    const Extent e = extent_along(segment, along_[g]);
    const bool is_near = std::fabs(dot(plane.normal, segment.fit.plane.normal)) >= kSameDirection &&
                         e.low <= extents_[g].high + kBeside_m &&
                         e.high >= extents_[g].low - kBeside_m;
    return is_near ? std::fabs(plane.distance(segment.fit.centroid)) : INFINITY;
  }

  const std::vector<Segment>& segments_;
  double largest_m2_ = 0;
  std::vector<WallGroup> groups_;
  std::vector<Vec3> along_;
  std::vector<Extent> extents_;
};

}  // namespace

bool is_upright(const Segment& segment) {
  return segment.has_plane() && std::fabs(segment.fit.plane.normal.z) <= kWallSine;
}

std::vector<WallGroup> wall_groups(const std::vector<Segment>& segments) {
  std::vector<size_t> order(segments.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return segments[a].area_m2 > segments[b].area_m2; });
  Grouping grouping(segments);
  for (const size_t s : order)
    if (is_upright(segments[s])) grouping.add(s);
  return grouping.take();
}

}  // namespace jalon
