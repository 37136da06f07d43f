// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <deque>

#include "geometry/circle.h"
#include "segment/codes/target_scene.h"

namespace jalon {

namespace {

constexpr size_t kGutterPointsPerChunk = 256;

// The points about the gutters' targets in plan, with their own search tree and normals.
class GutterPoints {
 public:
  GutterPoints(const TargetScene& scene, std::vector<uint32_t> points, Task& task)
      : scene_(scene), points_(std::move(points)), xyz_(3 * points_.size()) {
    Box3 box;
    for (size_t i = 0; i < points_.size(); ++i) {
      const Vec3 p = scene.local(points_[i]);
      box.add(p);
      for (int k = 0; k < 3; ++k) xyz_[3 * i + static_cast<size_t>(k)] = p[k];
    }
    tree_ = Octree::build(xyz_, enclosing_cube(box), task);
    normals_.resize(points_.size());
    parallel_for(task, points_.size(), kGutterPointsPerChunk, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) normals_[i] = normal_at(i);
    });
  }

  uint32_t cloud_index(uint32_t i) const { return points_[i]; }

  /// Grown from the point nearest to the target, in the order in which they join; empty when none is near.
  std::vector<uint32_t> grown(const Vec3& target, Task& task) const {
    Neighbour seed;
    if (!tree_->nearest_within(target, scene_.settings.gutter_reach_m, seed)) return {};
    std::vector<uint32_t> region{seed.index};
    std::vector<bool> in_region(points_.size(), false);
    in_region[seed.index] = true;
    std::vector<Neighbour> near;
    for (size_t at = 0; at < region.size(); ++at) {
      if (at % kGutterPointsPerChunk == 0) task.checkpoint(0.5);
      tree_->radius(point(region[at]), scene_.settings.growing_radius_m, near);
      for (const Neighbour& n : near) {
        if (in_region[n.index] || !joins(normals_[region[at]], normals_[n.index])) continue;
        in_region[n.index] = true;
        region.push_back(n.index);
      }
    }
    return region;
  }

 private:
  Vec3 point(size_t i) const { return {xyz_[3 * i], xyz_[3 * i + 1], xyz_[3 * i + 2]}; }

  // Zero with fewer than three neighbours: it joins nothing.
  Vec3 normal_at(size_t i) const {
    std::vector<Neighbour> near;
    tree_->radius(point(i), scene_.settings.gutter_normal_radius_m, near);
    Moments moments;
    moments.reference = point(i);
    size_t others = 0;
    for (const Neighbour& n : near)
      if (n.index != i) {
        moments.add(point(n.index));
        ++others;
      }
    PlaneFit fit;
    return others >= 3 && fit_plane(moments, fit) ? fit.plane.normal : Vec3{};
  }

  // Meant, not printed: nearly parallel or nearly opposite, and in both cases nearly level, up or down.
  bool joins(const Vec3& region, const Vec3& candidate) const {
    return std::fabs(dot(region, candidate)) > std::cos(scene_.settings.growing_angle_rad) &&
           std::fabs(candidate.z) < scene_.settings.most_normal_z;
  }

  const TargetScene& scene_;
  std::vector<uint32_t> points_;
  std::vector<double> xyz_;
  std::shared_ptr<const Octree> tree_;
  std::vector<Vec3> normals_;
};

// Form "improved": what lies on the circle about which the grown points lie, between their ends; they themselves where
// they lie about none.
std::vector<uint32_t> on_pipe(const TargetScene& scene, const std::vector<uint32_t>& grown,
                              Task& task) {
  constexpr double kOnCircle_m = 0.01, kThinnest_m = 0.01, kThickest_m = 0.15;
  constexpr size_t kFewestGrown = 40;
  std::vector<Vec2> plan;
  double low = INFINITY, high = -INFINITY;
  for (const uint32_t i : grown) {
    const Vec3 p = scene.local(i);
    plan.push_back(in_plan(p));
    low = std::min(low, p.z), high = std::max(high, p.z);
  }
  PrimitiveSetting setting;
  setting.tolerance_m = kOnCircle_m;
  setting.min_radius_m = kThinnest_m;
  setting.max_radius_m = kThickest_m;
  CircleFit fit;
  if (plan.size() < kFewestGrown || !fit_circle(plan, setting, task, fit)) return grown;
  return free_among(scene,
                    scene.tiles.points_about(fit.circle.centre, fit.circle.radius + kOnCircle_m),
                    [&](const Vec3& p) {
                      return p.z >= low && p.z <= high &&
                             std::fabs(fit.circle.distance(in_plan(p))) < kOnCircle_m;
                    });
}

}  // namespace

void take_gutters(TargetScene& scene, Task& task) {
  std::vector<uint32_t> numbers;
  for (uint32_t number = 1; number <= scene.objects.objects.size(); ++number)
    if (scene.objects.objects[number - 1].row.geometry == CodeGeometry::kGutterTarget)
      numbers.push_back(number);
  const auto target = [&](uint32_t number) {
    return scene.place(scene.objects.objects[number - 1].points.front());
  };
  const double reach = scene.settings.gutter_reach_m;
  std::vector<uint32_t> points;
  for (const uint32_t number : numbers) {
    const Vec2 at = in_plan(target(number));
    const std::vector<uint32_t> about =
        free_among(scene, scene.tiles.points_about(at, reach), [&](const Vec3& p) {
          const Vec2 d = in_plan(p) - at;
          return dot(d, d) < reach * reach;
        });
    points.insert(points.end(), about.begin(), about.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.empty()) return;
  const GutterPoints gutters(scene, std::move(points), task);
  for (const uint32_t number : numbers) {
    std::vector<uint32_t> region;
    for (const uint32_t i : gutters.grown(target(number), task))
      region.push_back(gutters.cloud_index(i));
    if (scene.is_improved()) region = on_pipe(scene, region, task);
    for (const uint32_t i : region)
      if (scene.owner[i] == 0) scene.owner[i] = number;
  }
}

}  // namespace jalon
