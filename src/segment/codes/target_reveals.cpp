// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "segment/codes/target_scene.h"

namespace jalon {

namespace {

constexpr double kAboutEdge_m = 0.05;  // of reveals from the edges of a frame
constexpr double kDeepest_m = 0.5;     // of a reveal, as between the two measurements of a corner
constexpr double kSillDrop_m = 0.10;   // of an inclined sill, from the frame to its wall

// The wall that lies before the opening, as the opening was found behind it.
const TargetWall* wall_of(const TargetScene& scene, const FoundOpening& opening,
                          const Vec3& middle) {
  const TargetWall* found = nullptr;
  double nearest = INFINITY;
  for (const TargetWall& wall : scene.walls) {
    constexpr double kParallelCosine = 0.94;  // 20 degrees
    if (std::fabs(dot(wall.plane.normal, opening.plane.normal)) < kParallelCosine) continue;
    const double off = std::fabs(wall.plane.distance(middle));
    if (off >= nearest) continue;
    nearest = off;
    found = &wall;
  }
  return found;
}

// In the ring about the frame's edges; below them as far as a sill falls.
bool is_about(const FoundOpening& o, double s, double z) {
  const double in = std::min({s - o.left_m, o.right_m - s, z - o.low_m, o.high_m - z});
  return in < kAboutEdge_m && z < o.high_m + kAboutEdge_m &&
         z > o.low_m - (o.has_sill ? kSillDrop_m : 0);
}

}  // namespace

void take_reveals(TargetScene& scene, Task& task) {
  for (const FoundOpening& o : scene.openings) {
    task.checkpoint(0.5);
    const double s = (o.left_m + o.right_m) / 2, z = (o.low_m + o.high_m) / 2;
    const Vec3 middle = o.along * s + o.plane.normal * o.plane.offset + Vec3{0, 0, z};
    const TargetWall* wall = wall_of(scene, o, middle);
    if (wall == nullptr) continue;
    const double reach = (o.right_m - o.left_m) / 2 + kDeepest_m;
    const double way = o.outside * dot(wall->plane.normal, o.plane.normal) > 0 ? 1 : -1;
    const auto is_wall = [&](const Vec3& p) {
      const double at = dot(p, o.along), off = way * wall->plane.distance(p);
      if (at < o.left_m - kAboutEdge_m || at > o.right_m + kAboutEdge_m ||
          off > scene.settings.wall_distance_m)
        return false;
      if (is_about(o, at, p.z)) return o.outside * o.plane.distance(p) > o.front.before(at);
      return p.z > o.high_m && p.z <= wall->high_m && off > -scene.settings.wall_distance_m;
    };
    for (const uint32_t i : free_about(scene, in_plan(middle), reach, is_wall))
      scene.owner[i] = wall->object;
  }
}

}  // namespace jalon
