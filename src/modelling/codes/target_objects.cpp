// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/target_objects.h"

#include <algorithm>
#include <cmath>

#include "geometry/circle.h"

namespace jalon {

namespace {

constexpr double kStrayShare = 0.01;      // of the points, at each end of an extent
constexpr size_t kFewestPoints = 20;      // that an extent or a circle is taken from
constexpr double kUprightNormal_z = 0.5;  // steeper planes are no walls, doors or windows
constexpr double kOffPipe_m = 0.01;       // five times the noise of a scanner
constexpr double kThinPipe_m = 0.01, kThickPipe_m = 0.3;  // radii of downpipes

// The extent of all but the strays at each end.
struct Extent1 {
  double low = 0, high = 0;
};
Extent1 extent_of(std::vector<double>& values) {
  const auto at = static_cast<std::ptrdiff_t>(kStrayShare * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  const double low = values[static_cast<size_t>(at)];
  std::nth_element(values.begin(), values.end() - 1 - at, values.end());
  return {low, *(values.end() - 1 - at)};
}

// Groups of points, along the wall, with gaps between them.
std::vector<std::vector<Vec2>> split_along(std::vector<Vec2> points, double gap_m) {
  std::sort(points.begin(), points.end(),
            [](const Vec2& a, const Vec2& b) { return a.u != b.u ? a.u < b.u : a.v < b.v; });
  std::vector<std::vector<Vec2>> groups;
  for (const Vec2& p : points) {
    if (groups.empty() || p.u - groups.back().back().u > gap_m) groups.emplace_back();
    groups.back().push_back(p);
  }
  return groups;
}

std::vector<CodedWall> rectangles(const Plane& plane, const std::vector<Vec3>& points,
                                  double gap_m) {
  const Vec2 out =
      Vec2{plane.normal.x, plane.normal.y} * (1 / norm(Vec2{plane.normal.x, plane.normal.y}));
  const Vec2 along{-out.v, out.u};
  std::vector<Vec2> flat;
  for (const Vec3& p : points) flat.push_back({dot(Vec2{p.x, p.y}, along), p.z});
  std::vector<CodedWall> found;
  for (const std::vector<Vec2>& group : split_along(std::move(flat), gap_m)) {
    if (group.size() < kFewestPoints) continue;
    std::vector<double> s, z;
    for (const Vec2& p : group) s.push_back(p.u), z.push_back(p.v);
    const Extent1 width = extent_of(s), height = extent_of(z);
    if (!(width.high > width.low) || !(height.high > height.low)) continue;
    // The plane where it is at half the height.
    const double middle = 0.5 * (height.low + height.high);
    const double offset =
        (plane.offset - plane.normal.z * middle) / norm(Vec2{plane.normal.x, plane.normal.y});
    found.push_back({out * offset + along * width.low, out * offset + along * width.high,
                     height.low, height.high});
  }
  return found;
}

void fit_pipe(const std::vector<Vec3>& points, MeasuredShape& shape, Task& task) {
  if (points.size() < kFewestPoints) return;
  std::vector<Vec2> flat;
  std::vector<double> z;
  for (const Vec3& p : points) flat.push_back({p.x, p.y}), z.push_back(p.z);
  CircleFit fit;
  if (!fit_circle(flat, {kOffPipe_m, kThinPipe_m, kThickPipe_m, true, 1}, task, fit)) return;
  const Extent1 height = extent_of(z);
  const Vec2 centre = fit.circle.centre;
  shape.axis = {{centre.u, centre.v, height.low}, {centre.u, centre.v, height.high}};
  shape.radius_m = fit.circle.radius;
}

}  // namespace

std::vector<MeasuredShape> target_shapes(const Segmentation& segmentation, const CodedNotes& notes,
                                         const Vec3& origin, double gap_m, Task& task) {
  std::vector<size_t> object_of(segmentation.segments.size() + 1, notes.objects.size());
  for (size_t i = 0; i < notes.objects.size(); ++i) {
    const NotedObject& o = notes.objects[i];
    if (o.geometry.ends_with("_target") && o.label < object_of.size()) object_of[o.label] = i;
  }
  object_of[0] = notes.objects.size();
  std::vector<std::vector<Vec3>> points(notes.objects.size() + 1);
  const auto labels = segmentation.labels->values<uint32_t>();
  for (size_t i = 0; i < labels.size(); ++i)
    if (labels[i] < object_of.size() && object_of[labels[i]] < notes.objects.size())
      points[object_of[labels[i]]].push_back(segmentation.cloud->point(i) - origin);
  std::vector<MeasuredShape> out(notes.objects.size());
  for (size_t i = 0; i < out.size(); ++i) {
    if (points[i].empty()) continue;
    task.checkpoint(static_cast<double>(i) / static_cast<double>(out.size()));
    const NotedObject& o = notes.objects[i];
    const Segment& segment = segmentation.segments[o.label - 1];
    if (o.geometry == "gutter_target") fit_pipe(points[i], out[i], task);
    else if (segment.has_plane() && std::fabs(segment.fit.plane.normal.z) < kUprightNormal_z) {
      Plane plane = segment.fit.plane;
      plane.offset -= dot(plane.normal, origin);
      out[i].rectangles =
          rectangles(plane, points[i], o.geometry == "window_target" ? gap_m : INFINITY);
    }
  }
  return out;
}

}  // namespace jalon
