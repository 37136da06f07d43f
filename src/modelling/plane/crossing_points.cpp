// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/crossing_points.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kCrossingPointsFlattest =
    0.94;  // |cos| of 20 degrees: flatter planes share more than a row of points
constexpr double kOn = 3, kLeastSigma_m = 0.001;  // sigma: of points on a plane
constexpr double kBoxSlack_m = 1e-6;  // far above the rounding of coordinates of seven digits
constexpr int kLeastBeside = 2;       // points on one side of a plane before it goes on there

double on_plane_m(const Segment& segment) {
  return kOn * std::max(segment.fit.sigma, kLeastSigma_m);
}

// The offset of a plane far from the origin has lost bits that no result may hang on.
constexpr double kHeightStep_m = 0x1p-20;
double height_m(const Segment& segment, const Vec3& p) {
  return std::round(segment.fit.plane.distance(p) / kHeightStep_m) * kHeightStep_m;
}

}  // namespace

CrossingPoints::CrossingPoints(const Segmentation& segmentation, const Octree& tree, size_t segment,
                               std::span<const Box3> boxes)
    : segmentation_(segmentation), tree_(tree), own_(segmentation.segments[segment]) {
  crosses_.assign(segmentation.segments.size() + 1, 0);
  for (size_t s = 0; s < segmentation.segments.size(); ++s) {
    const Segment& other = segmentation.segments[s];
    const Plane& plane = other.fit.plane;
    if (!other.has_plane() ||
        std::fabs(dot(plane.normal, own_.fit.plane.normal)) >= kCrossingPointsFlattest)
      continue;
    crosses_[other.label] = 1;
    crossing_.x.push_back(plane.normal.x);
    crossing_.y.push_back(plane.normal.y);
    crossing_.z.push_back(plane.normal.z);
    crossing_.offset.push_back(plane.offset);
    crossing_.reach_m.push_back(on_plane_m(other) + kHeightStep_m);
    crossing_.box.push_back(boxes[s]);
  }
}

// Most points lie on no other plane, which is told much sooner than what is around them.
bool CrossingPoints::lies_on_one(const Vec3& p) const {
  const Crossing& c = crossing_;
  uint64_t on = 0;
  for (size_t i = 0; i < c.x.size(); ++i) {
    const double height = c.x[i] * p.x + c.y[i] * p.y + c.z[i] * p.z - c.offset[i];
    on |= static_cast<uint64_t>(std::fabs(height) <= c.reach_m[i]);
  }
  return on != 0;
}

// Planes go on without end; their points do not, and a point far from all of them has none around it.
bool CrossingPoints::has_one_near(const Vec3& p, double reach_m) const {
  const Crossing& c = crossing_;
  const double wide = reach_m + kBoxSlack_m;
  for (size_t i = 0; i < c.x.size(); ++i) {
    const double height = c.x[i] * p.x + c.y[i] * p.y + c.z[i] * p.z - c.offset[i];
    if (!(std::fabs(height) <= c.reach_m[i])) continue;
    const Vec3 below = c.box[i].min - p, above = p - c.box[i].max;
    if (std::max({below.x, below.y, below.z, above.x, above.y, above.z}) <= wide) return true;
  }
  return false;
}

bool CrossingPoints::ends_at(const Segment& other, const Vec3& p,
                             const std::vector<Neighbour>& near) const {
  const double on_other = on_plane_m(other), on_own = on_plane_m(own_);
  if (std::fabs(height_m(other, p)) > on_other) return false;
  const Cloud& cloud = *segmentation_.cloud;
  const auto labels = segmentation_.labels->values<uint32_t>();
  int before = 0, behind = 0, above = 0, below = 0;
  for (const Neighbour& n : near) {
    if (labels[n.index] == other.label) {
      const double h = height_m(own_, cloud.point(n.index));
      before += h > on_own;
      behind += h < -on_own;
    } else if (labels[n.index] == own_.label) {
      const double h = height_m(other, cloud.point(n.index));
      above += h > on_other;
      below += h < -on_other;
    }
  }
  return std::min(before, behind) >= kLeastBeside && std::min(above, below) < kLeastBeside;
}

bool CrossingPoints::holds(uint32_t point, double reach_m) const {
  const Vec3 p = segmentation_.cloud->point(point);
  if (!lies_on_one(p) || !has_one_near(p, reach_m)) return false;
  const auto labels = segmentation_.labels->values<uint32_t>();
  std::vector<Neighbour> near;
  tree_.radius(p, reach_m, near);
  std::vector<uint32_t> others;
  for (const Neighbour& n : near)
    if (const uint32_t label = labels[n.index]; crosses_[label] != 0) others.push_back(label);
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  return std::any_of(others.begin(), others.end(), [&](uint32_t label) {
    return ends_at(segmentation_.segments[label - 1], p, near);
  });
}

}  // namespace jalon
