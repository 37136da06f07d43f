// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "geometry/circle.h"
#include "segment/codes/target_scene.h"

namespace jalon {

namespace {

constexpr size_t kGutterPointsPerChunk = 256;
constexpr uint32_t kDozen = 12;
constexpr double kLongest =
    2;  // times the text's radii: then normals are those of more than the pipe

// The points about the gutters' targets in plan, with their own search tree and normals.
class GutterPoints {
 public:
  /// seed: of form "improved" the target about which a coarse scan makes the radii longer; else null.
  GutterPoints(const TargetScene& scene, std::vector<uint32_t> points, const Vec3* seed, Task& task)
      : scene_(scene),
        points_(std::move(points)),
        xyz_(3 * points_.size()),
        has_more_seeds_(seed != nullptr) {
    Box3 box;
    for (size_t i = 0; i < points_.size(); ++i) {
      const Vec3 p = scene.local(points_[i]);
      box.add(p);
      for (int k = 0; k < 3; ++k) xyz_[3 * i + static_cast<size_t>(k)] = p[k];
    }
    tree_ = Octree::build(xyz_, enclosing_cube(box), task);
    if (seed != nullptr) longer_ = longer_about(*seed);
    normals_.resize(points_.size());
    parallel_for(task, points_.size(), kGutterPointsPerChunk, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) normals_[i] = normal_at(i);
    });
  }

  /// Points of the cloud, grown from that nearest to the target, in the order in which they join; none when none is
  /// near.
  std::vector<uint32_t> grown(const Vec3& target, Task& task) const {
    Neighbour seed;
    if (!tree_->nearest_within(target, scene_.settings.gutter_reach_m, seed)) return {};
    std::vector<uint32_t> region{seed.index};
    // Form "improved": the dozen about it too, as one normal of a coarse scan may be amiss.
    if (has_more_seeds_) {
      std::array<Neighbour, kDozen> about;
      const size_t n = tree_->knn(point(seed.index), kDozen, about);
      for (size_t k = 0; k < n; ++k)
        if (about[k].index != seed.index) region.push_back(about[k].index);
    }
    std::vector<bool> in_region(points_.size(), false);
    for (const uint32_t i : region) in_region[i] = true;
    std::vector<Neighbour> near;
    for (size_t at = 0; at < region.size(); ++at) {
      if (at % kGutterPointsPerChunk == 0) task.checkpoint(0.5);
      tree_->radius(point(region[at]), longer_ * scene_.settings.growing_radius_m, near);
      for (const Neighbour& n : near) {
        if (in_region[n.index] || !joins(normals_[region[at]], normals_[n.index])) continue;
        in_region[n.index] = true;
        region.push_back(n.index);
      }
    }
    for (uint32_t& i : region) i = points_[i];
    return region;
  }

 private:
  Vec3 point(size_t i) const { return {xyz_[3 * i], xyz_[3 * i + 1], xyz_[3 * i + 2]}; }

  // The text's radii are for 10 000 points/m2 or more, a dozen within the radius of growing: as much as the dozenth is
  // farther about the target.
  double longer_about(const Vec3& target) const {
    Neighbour seed;
    if (!tree_->nearest_within(target, scene_.settings.gutter_reach_m, seed)) return 1;
    std::array<Neighbour, kDozen> about, own;
    const size_t n = tree_->knn(point(seed.index), kDozen, about);
    std::vector<double> farthest;
    for (size_t k = 0; k < n; ++k) {
      const size_t m = tree_->knn(point(about[k].index), kDozen, own);
      farthest.push_back(std::sqrt(own[m - 1].squared_distance));
    }
    std::nth_element(farthest.begin(), farthest.begin() + static_cast<std::ptrdiff_t>(n / 2),
                     farthest.end());
    return std::clamp(farthest[n / 2] / scene_.settings.growing_radius_m, 1.0, kLongest);
  }

  // Zero with fewer than three neighbours: it joins nothing.
  Vec3 normal_at(size_t i) const {
    std::vector<Neighbour> near;
    tree_->radius(point(i), longer_ * scene_.settings.gutter_normal_radius_m, near);
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
  double longer_ = 1;
  bool has_more_seeds_ = false;
  std::vector<Vec3> normals_;
};

// From low to high as far up and down as the heights of points leave no gap.
void extend(std::vector<double> heights, double& low, double& high) {
  constexpr double kGap_m = 0.10;  // five steps of growing
  std::sort(heights.begin(), heights.end());
  for (const double z : heights)
    if (z > high && z < high + kGap_m) high = z;
  for (auto z = heights.rbegin(); z != heights.rend(); ++z)
    if (*z<low&& * z> low - kGap_m) low = *z;
}

constexpr double kOnCircle_m = 0.01;

// The circle about which grown points lie. Where they went on into the wall, its waves are many points and may be as
// round as the pipe: the target sticks on the circle that is meant, and near it there is less of the wall. A circle
// off the target is better than none, as lists err too.
bool fit_pipe_of_target(const std::vector<Vec2>& grown, const Vec2& target, Task& task,
                        CircleFit& fit) {
  constexpr double kThinnest_m = 0.01, kThickest_m = 0.15;
  constexpr double kAbout_m[] = {INFINITY, 0.10, 0.06};  // 0.054 to the sides of a usual pipe
  constexpr double kOffTarget_m = kOnCircle_m + 0.005;   // and a georeferencing's residual
  constexpr size_t kFewestGrown = 40;
  PrimitiveSetting setting;
  setting.tolerance_m = kOnCircle_m;
  setting.min_radius_m = kThinnest_m;
  setting.max_radius_m = kThickest_m;
  bool is_found = false;
  for (const double about : kAbout_m) {
    std::vector<Vec2> near;
    for (const Vec2& p : grown)
      if (norm(p - target) < about) near.push_back(p);
    CircleFit found;
    if (near.size() < kFewestGrown || !fit_circle(near, setting, task, found)) continue;
    const bool is_meant = std::fabs(found.circle.distance(target)) < kOffTarget_m;
    if (is_meant || !is_found) fit = found;
    is_found = true;
    if (is_meant) break;
  }
  return is_found;
}

// Form "improved": what lies on the side that is seen of the circle about which the grown points lie, from end to end;
// they themselves where they lie about none.
std::vector<uint32_t> on_pipe(const TargetScene& scene, const std::vector<uint32_t>& grown,
                              const Vec2& target, Task& task) {
  constexpr double kFront = 0.5, kSide = -0.1;  // of the radius, towards the viewer
  std::vector<Vec2> plan;
  for (const uint32_t i : grown) plan.push_back(in_plan(scene.local(i)));
  CircleFit fit;
  if (!fit_pipe_of_target(plan, target, task, fit)) return grown;
  const Circle& circle = fit.circle;
  // Seen is the side of the target; where between the pipe's sides it sticks says nothing.
  Vec2 outward;
  double low = INFINITY, high = -INFINITY;
  for (const uint32_t i : grown) {
    const Vec3 p = scene.local(i);
    const Vec2 d = in_plan(p) - circle.centre;
    if (std::fabs(circle.distance(in_plan(p))) > kOnCircle_m || dot(d, target - circle.centre) < 0)
      continue;
    outward = outward + d;
    low = std::min(low, p.z), high = std::max(high, p.z);
  }
  if (norm(outward) == 0) return grown;
  outward = outward * (1 / norm(outward));
  const auto side = [&](const Vec3& p) {
    return dot(in_plan(p) - circle.centre, outward) / circle.radius;
  };
  std::vector<uint32_t> on =
      free_about(scene, circle.centre, circle.radius + kOnCircle_m, [&](const Vec3& p) {
        return std::fabs(circle.distance(in_plan(p))) < kOnCircle_m && side(p) > kSide;
      });
  std::vector<double> heights;
  for (const uint32_t i : on)
    if (side(scene.local(i)) > kFront) heights.push_back(scene.local(i).z);
  extend(std::move(heights), low, high);
  std::erase_if(on, [&](uint32_t i) { return scene.local(i).z < low || scene.local(i).z > high; });
  return on;
}

void give(TargetScene& scene, const std::vector<uint32_t>& points, uint32_t number) {
  for (const uint32_t i : points)
    if (scene.owner[i] == 0) scene.owner[i] = number;
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
  std::vector<uint32_t> all;
  for (const uint32_t number : numbers) {
    const Vec3 place = target(number);
    std::vector<uint32_t> about = free_about(scene, in_plan(place), reach, [&](const Vec3& p) {
      const Vec2 d = in_plan(p - place);
      return dot(d, d) < reach * reach;
    });
    if (about.empty()) continue;
    if (!scene.is_improved()) {
      all.insert(all.end(), about.begin(), about.end());
      continue;
    }
    const GutterPoints gutter(scene, std::move(about), &place, task);
    give(scene, on_pipe(scene, gutter.grown(place, task), in_plan(place), task), number);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (all.empty()) return;
  const GutterPoints gutters(scene, std::move(all), nullptr, task);
  for (const uint32_t number : numbers) give(scene, gutters.grown(target(number), task), number);
}

}  // namespace jalon
