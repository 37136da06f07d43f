// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/codes/target_objects.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <tuple>

#include "geometry/circle.h"
#include "segment/codes/coded_object.h"

namespace jalon {

namespace {

constexpr double kStrayShare = 0.01;      // of the points, at each end of an extent
constexpr double kUprightNormal_z = 0.5;  // steeper planes are no walls, doors or windows
constexpr double kLayer_m = 0.01;         // of a front: five times the noise of a scanner
constexpr double kDenseBin_m = 0.05, kDenseShare = 0.2;  // of a door: beside panes half is frame
constexpr int64_t kMostThinBins = 3;     // what stood before a leaf hides some of it
constexpr double kTargetReach_m = 0.08;  // half the diagonal of 10 x 10 cm, and noise
constexpr double kLeastFlat = 1.0 / 3;   // of an opening's points in the layer of its front
constexpr double kOffPipe_m = 0.01;      // five times the noise of a scanner
constexpr double kThinPipe_m = 0.01, kThickPipe_m = 0.3;  // radii of downpipes

struct Extent1 {
  double low = 0, high = 0;
};

// The extent of all but the strays at each end. As many of an object's own points lie beyond it: it reaches on as far
// as these would at the density of its border.
Extent1 extent_of(std::vector<double>& values) {
  const auto at = static_cast<std::ptrdiff_t>(kStrayShare * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  const double low = values[static_cast<size_t>(at)];
  std::nth_element(values.begin(), values.end() - 1 - at, values.end());
  const double high = *(values.end() - 1 - at), border = kStrayShare * (high - low);
  if (!(border > 0)) return {low, high};
  struct Counts {
    double beyond = 0, within = 0;
    void add(double into) {
      if (into >= 0 && into <= 1) ++within;
      else if (into < 0 && into >= -1) ++beyond;
    }
    double further() const { return std::min(1.0, beyond / std::max(1.0, within)); }
  } at_low, at_high;
  for (const double v : values) {
    at_low.add((v - low) / border);
    at_high.add((high - v) / border);
  }
  return {low - border * at_low.further(), high + border * at_high.further()};
}

// The median of the centimetre that holds the most distances; nothing where it holds few, as of a leaf that is open.
std::optional<double> front_of(std::vector<double>& distances) {
  std::sort(distances.begin(), distances.end());
  size_t first = 0, most = 0;
  for (size_t begin = 0, end = 0; end < distances.size(); ++end) {
    while (distances[end] - distances[begin] > kLayer_m) ++begin;
    if (end + 1 - begin > most) most = end + 1 - begin, first = begin;
  }
  if (static_cast<double>(most) < kLeastFlat * static_cast<double>(distances.size())) return {};
  return distances[first + most / 2];
}

// Groups of points (place along the wall, distance from its plane, height), with gaps along it between them.
std::vector<std::vector<Vec3>> split_along(std::vector<Vec3> points, double gap_m) {
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.z, a.y) < std::tie(b.x, b.z, b.y);
  });
  std::vector<std::vector<Vec3>> groups;
  for (const Vec3& p : points) {
    if (groups.empty() || p.x - groups.back().back().x > gap_m) groups.emplace_back();
    groups.back().push_back(p);
  }
  return groups;
}

// Of points (place along the wall, distance from its plane, height) those in the bins about a target's that hold a
// fifth of what full ones do, along one axis: a door reaches to its frame, and what is strewn over the wall beside
// it is none. The target itself is scanned more densely.
std::vector<Vec3> dense_about(const std::vector<Vec3>& points, const Vec3& target, int axis) {
  std::map<int64_t, double> counts;
  const auto bin_of = [&](const Vec3& p) {
    return static_cast<int64_t>(std::floor((p[axis] - target[axis]) / kDenseBin_m));
  };
  for (const Vec3& p : points)
    if (norm(Vec2{p.x - target.x, p.z - target.z}) > kTargetReach_m) ++counts[bin_of(p)];
  std::vector<double> sizes;
  for (const auto& [bin, count] : counts) sizes.push_back(count);
  if (sizes.empty()) return points;
  const auto full = sizes.end() - 1 - static_cast<std::ptrdiff_t>(sizes.size() / 10);
  std::nth_element(sizes.begin(), full, sizes.end());
  const double least = kDenseShare * *full;
  const auto reach_of = [&](int64_t step) {
    int64_t reach = 0;
    for (int64_t bin = step; std::abs(bin - reach) <= kMostThinBins + 1; bin += step)
      if (const auto found = counts.find(bin); found != counts.end() && found->second >= least)
        reach = bin;
    return reach;
  };
  const int64_t low = reach_of(-1), high = reach_of(1);
  std::vector<Vec3> out;
  for (const Vec3& p : points)
    if (bin_of(p) >= low && bin_of(p) <= high) out.push_back(p);
  return out;
}

// Points that lie together along the wall, and how far their front stands before the plane of all.
struct Group {
  Extent1 width, height;
  std::optional<double> front_m;
};

std::vector<Group> groups_of(const std::vector<Vec3>& flat, double gap_m) {
  std::vector<Group> out;
  for (const std::vector<Vec3>& points : split_along(flat, gap_m)) {
    if (points.size() < kFewestDrawnPoints) continue;
    std::vector<double> s, d, z;
    for (const Vec3& p : points) s.push_back(p.x), d.push_back(p.y), z.push_back(p.z);
    const Group group{extent_of(s), extent_of(z), front_of(d)};
    if (group.width.high > group.width.low && group.height.high > group.height.low)
      out.push_back(group);
  }
  return out;
}

// Where the fronts of the others stand.
double usual_front(const std::vector<Group>& groups) {
  std::vector<double> fronts;
  for (const Group& group : groups)
    if (group.front_m) fronts.push_back(*group.front_m);
  std::sort(fronts.begin(), fronts.end());
  return fronts.empty() ? 0 : fronts[fronts.size() / 2];
}

// Frames of one facade differ in depth, and a leaf that stands open draws the plane of all: each opening has its own.
// A wall of corrugated sheet has two fronts, and its plane between them.
std::vector<CodedWall> rectangles(const Plane& plane, const std::vector<Vec3>& points,
                                  bool has_front, double gap_m, const Vec3* target) {
  const double level = norm(Vec2{plane.normal.x, plane.normal.y});
  const Vec2 out = Vec2{plane.normal.x, plane.normal.y} * (1 / level), along{-out.v, out.u};
  std::vector<Vec3> flat;
  for (const Vec3& p : points) flat.push_back({dot(Vec2{p.x, p.y}, along), plane.distance(p), p.z});
  if (target != nullptr) {
    const Vec3 place{dot(Vec2{target->x, target->y}, along), 0, target->z};
    for (const int axis : {0, 2}) flat = dense_about(flat, place, axis);
  }
  const std::vector<Group> groups = groups_of(flat, gap_m);
  const double usual_m = usual_front(groups);
  std::vector<CodedWall> found;
  for (const Group& group : groups) {
    const Extent1 &width = group.width, &height = group.height;
    const double front_m = has_front ? group.front_m.value_or(usual_m) : 0;
    // The plane where it is at half the height.
    const double middle = 0.5 * (height.low + height.high);
    const double offset = (plane.offset + front_m - plane.normal.z * middle) / level;
    found.push_back({out * offset + along * width.low, out * offset + along * width.high,
                     height.low, height.high});
  }
  return found;
}

void fit_pipe(const std::vector<Vec3>& points, MeasuredShape& shape, Task& task) {
  if (points.size() < kFewestDrawnPoints) return;
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
      const Vec3 target = o.surveyed.empty() ? Vec3{} : o.surveyed.front().place - origin;
      out[i].rectangles =
          rectangles(plane, points[i], o.geometry != "wall_target",
                     o.geometry == "window_target" ? gap_m : INFINITY,
                     o.geometry == "door_target" && !o.surveyed.empty() ? &target : nullptr);
    }
  }
  return out;
}

}  // namespace jalon
