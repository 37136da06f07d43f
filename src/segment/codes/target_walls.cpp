// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>

#include "base/random.h"
#include "segment/codes/target_scene.h"

namespace jalon {

namespace {

constexpr size_t kSlabPointsPerChunk = 1 << 15;

struct WallPoint {
  uint32_t index, object;
};

size_t support(std::span<const Vec3> slab, const Plane& plane, double distance_m, Task& task) {
  return parallel_reduce(task, slab.size(), kSlabPointsPerChunk, size_t{0},
                         [&](size_t begin, size_t end) {
                           size_t count = 0;
                           for (size_t i = begin; i < end; ++i)
                             count += std::fabs(plane.distance(slab[i])) < distance_m;
                           return count;
                         });
}

std::vector<Vec3> places_of(const TargetScene& scene, const std::vector<uint32_t>& slab) {
  std::vector<Vec3> places;
  places.reserve(slab.size());
  for (const uint32_t i : slab) places.push_back(scene.local(i));
  return places;
}

// Planes through the target and two points of the slab (Fischler & Bolles 1981, guided by the target). A normal's sign
// is arbitrary: the angle is that between the lines.
std::optional<Plane> drawn_wall(const TargetScene& scene, const CodedPoint& target,
                                std::span<const Vec3> slab, const Plane& first, uint64_t stream,
                                Task& task) {
  std::optional<Plane> best;
  size_t most = 0;
  if (slab.size() < 2) return best;
  RandomStream random(scene.settings.seed, stream);
  const Vec3 centre = scene.place(target);
  const double least_cosine = std::cos(scene.settings.wall_angle_rad);
  for (int64_t draw = 0; draw < scene.settings.wall_draws; ++draw) {
    const size_t a = random.below(slab.size());
    size_t b = random.below(slab.size() - 1);
    if (b >= a) ++b;
    const Vec3 normal = normalized(cross(slab[a] - centre, slab[b] - centre));
    if (!(std::fabs(dot(normal, first.normal)) > least_cosine)) continue;
    const Plane plane{normal, dot(normal, centre)};
    const size_t count = support(slab, plane, scene.settings.wall_distance_m, task);
    if (count <= most) continue;
    most = count;
    best = plane;
  }
  return best;
}

// Form "improved": least squares over what lies about the drawn plane, which passes through a target before the waves
// of a corrugated sheet.
Plane adjusted_wall(const TargetScene& scene, const std::vector<uint32_t>& slab, Plane plane) {
  constexpr int kAdjustments = 3;
  for (int round = 0; round < kAdjustments; ++round) {
    std::vector<uint32_t> near;
    for (const uint32_t i : slab)
      if (std::fabs(plane.distance(scene.local(i))) < scene.settings.wall_distance_m)
        near.push_back(i);
    const auto better = plane_of(scene, near);
    if (!better) break;
    plane = *better;
  }
  return plane;
}

// How high what was left of each wall reaches.
void set_heights(TargetScene& scene, std::span<const WallPoint> walls) {
  for (const WallPoint& p : walls)
    if (scene.owner[p.index] != 0)
      for (TargetWall& wall : scene.walls)
        if (wall.object == p.object) wall.high_m = std::max(wall.high_m, scene.local(p.index).z);
}

void take_wall(TargetScene& scene, uint32_t number, std::vector<WallPoint>& walls, Task& task) {
  const CodedObject& object = scene.objects.objects[number - 1];
  const CodedPoint& target = object.points.front();
  const auto first = plane_of(scene, patch_of(scene, target, true));
  if (!first) return warn_of_target(scene, object, "fewer than three points lie at its target");
  const std::vector<uint32_t> slab = free_points(
      scene, [&](const Vec3& p) { return std::fabs(first->distance(p)) < scene.settings.slab_m; },
      task);
  auto plane = drawn_wall(scene, target, places_of(scene, slab), *first, number, task);
  if (!plane) {
    warn_of_target(scene, object, "no drawn plane is near that of its target, which is taken");
    plane = first;
  }
  if (scene.is_improved()) {
    plane = adjusted_wall(scene, slab, *plane);
    scene.walls.push_back({.object = number, .plane = *plane});
  }
  for (const uint32_t i : slab)
    if (std::fabs(plane->distance(scene.local(i))) < scene.settings.wall_distance_m) {
      scene.owner[i] = number;
      walls.push_back({i, number});
    }
}

// Height of the first empty class of the histogram of walls' heights; infinite when none is empty.
double top_of(const TargetScene& scene, std::span<const WallPoint> walls) {
  double low = INFINITY, high = -INFINITY;
  for (const WallPoint& p : walls) {
    low = std::min(low, scene.local(p.index).z);
    high = std::max(high, scene.local(p.index).z);
  }
  const auto bins = static_cast<size_t>(scene.settings.height_bins);
  const double width = (high - low) / static_cast<double>(bins);
  if (!(width > 0)) return INFINITY;
  std::vector<size_t> counts(bins, 0);
  for (const WallPoint& p : walls)
    ++counts[std::min(bins - 1, static_cast<size_t>((scene.local(p.index).z - low) / width))];
  const auto gap = std::find(counts.begin(), counts.end(), size_t{0});
  return gap == counts.end() ? INFINITY : low + static_cast<double>(gap - counts.begin()) * width;
}

struct Extent {
  double low = INFINITY, high = -INFINITY;
};

// The columns of the plan and between which heights their points lie.
class Columns {
 public:
  Columns(const TargetScene& scene, std::span<const WallPoint> walls, double top_m, double cell_m)
      : cell_m_(cell_m) {
    for (const WallPoint& point : walls) {
      const Vec3 p = scene.local(point.index);
      if (p.z >= top_m) continue;
      Extent& extent = extents_[key(p)];
      extent.low = std::min(extent.low, p.z);
      extent.high = std::max(extent.high, p.z);
    }
  }
  size_t size() const { return extents_.size(); }
  double height_at(const Vec3& p) const {
    const auto column = extents_.find(key(p));
    return column == extents_.end() ? 0 : column->second.high - column->second.low;
  }

 private:
  uint64_t key(const Vec3& p) const {
    const auto x = static_cast<int64_t>(std::floor(p.x / cell_m_));
    const auto y = static_cast<int64_t>(std::floor(p.y / cell_m_));
    return static_cast<uint64_t>(x) << 32 ^ (static_cast<uint64_t>(y) & 0xffffffffu);
  }
  double cell_m_;
  std::unordered_map<uint64_t, Extent> extents_;
};

// Columns of the plan whose points do not reach the height of a wall go back, and what lies above the gap. Form
// "improved": columns wide enough for a coarse scan to show how high their wall is.
void cut_walls(TargetScene& scene, std::span<const WallPoint> walls) {
  constexpr size_t kPointsInColumn = 40;
  constexpr int kMostDoublings = 3;
  const double top = top_of(scene, walls);
  double cell = scene.settings.wall_cell_m;
  Columns columns(scene, walls, top, cell);
  for (int k = 0; scene.is_improved() && k < kMostDoublings; ++k) {
    if (walls.size() >= kPointsInColumn * columns.size()) break;
    columns = Columns(scene, walls, top, cell *= 2);
  }
  for (const WallPoint& point : walls) {
    const Vec3 p = scene.local(point.index);
    if (p.z >= top || columns.height_at(p) < scene.settings.least_wall_height_m)
      scene.owner[point.index] = 0;
  }
}

}  // namespace

void take_walls(TargetScene& scene, Task& task) {
  std::vector<WallPoint> walls;
  for (uint32_t number = 1; number <= scene.objects.objects.size(); ++number)
    if (scene.objects.objects[number - 1].row.geometry == CodeGeometry::kWallTarget)
      take_wall(scene, number, walls, task);
  task.checkpoint(1);
  if (!scene.is_improved()) return cut_walls(scene, walls);
  // Buildings differ in height: each wall ends below its own gap.
  for (size_t first = 0, end = 0; first < walls.size(); first = end) {
    while (end < walls.size() && walls[end].object == walls[first].object) ++end;
    cut_walls(scene, std::span(walls).subspan(first, end - first));
  }
  set_heights(scene, walls);
}

}  // namespace jalon
