// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/crossing_lines.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kFlattest = 0.94;  // |cos| of 20 degrees: flatter planes have no useful line
constexpr size_t kSamples = 256;    // points of a plane that tell on which sides it lies

// The offset of a plane far from the origin has lost bits that no result may hang on.
double height_m(const Plane& plane, const Vec3& p) {
  return std::round(plane.distance(p) * 0x1p20) * 0x1p-20;
}

bool reaches(const Cloud& cloud, std::span<const uint32_t> points, const Plane& plane,
             double reach_m) {
  const size_t step = points.size() / kSamples + 1;
  double low = INFINITY, high = -INFINITY;
  for (size_t i = 0; i < points.size(); i += step) {
    const double h = plane.distance(cloud.point(points[i]));
    low = std::min(low, h);
    high = std::max(high, h);
    if (low <= reach_m && high >= -reach_m) return true;
  }
  return false;
}

}  // namespace

std::vector<EdgeLine> crossing_lines(const Segmentation& segmentation, const LabelGroups& groups,
                                     size_t segment, const PlaneFrame& frame, double reach_m) {
  const Plane& own = segmentation.segments[segment].fit.plane;
  std::vector<EdgeLine> out;
  for (const Segment& other : segmentation.segments) {
    const Plane& plane = other.fit.plane;
    if (!other.has_plane() || std::fabs(dot(plane.normal, own.normal)) > kFlattest) continue;
    if (!reaches(*segmentation.cloud, groups.of(other.label), own, reach_m)) continue;
    // The other plane's height in these coordinates: rise . (p - foot).
    const Vec2 rise{dot(plane.normal, frame.axis_u), dot(plane.normal, frame.axis_v)};
    const double height = height_m(plane, frame.lift({0, 0}));
    out.push_back({rise * (-height / dot(rise, rise)), Vec2{-rise.v, rise.u} * (1 / norm(rise))});
  }
  return out;
}

}  // namespace jalon
