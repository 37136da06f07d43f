// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "segment/codes/target_scene.h"

namespace jalon {

namespace {

// How far two targets of a facade may lie off their common plane, and the cosine of 20 degrees between it and the patch
// of 10 cm at each.
constexpr double kOneFacade_m = 0.05, kOneFacadeCosine = 0.94;

void take_door(TargetScene& scene, uint32_t number, Task& task) {
  const CodedObject& object = scene.objects.objects[number - 1];
  const CodedPoint& target = object.points.front();
  const auto plane = plane_of(scene, patch_of(scene, target, false, task));
  if (!plane)
    return warn_of_target(
        scene, object,
        "fewer than three free points lie at its target: flush with its wall, or hidden");
  const Vec3 centre = scene.place(target);
  const double most = scene.settings.door_radius_m * scene.settings.door_radius_m;
  for (const uint32_t i : free_points(
           scene,
           [&](const Vec3& p) {
             return std::fabs(plane->distance(p)) < object.row.distance_m &&
                    squared_norm(p - centre) < most;
           },
           task))
    scene.owner[i] = number;
}

// Strictly between two places, widened by the margin, along every axis.
bool between(const Vec3& p, const Vec3& a, const Vec3& b, double margin) {
  for (int k = 0; k < 3; ++k)
    if (!(p[k] > std::min(a[k], b[k]) - margin && p[k] < std::max(a[k], b[k]) + margin))
      return false;
  return true;
}

void take_facade(TargetScene& scene, uint32_t number, Task& task) {
  const CodedObject& object = scene.objects.objects[number - 1];
  std::vector<uint32_t> patch;
  std::vector<Plane> own;
  for (const CodedPoint& target : object.points) {
    const std::vector<uint32_t> part = patch_of(scene, target, false, task);
    patch.insert(patch.end(), part.begin(), part.end());
    const auto plane = plane_of(scene, part);
    if (!plane)
      return warn_of_target(scene, object,
                            "fewer than three free points lie at target " + target.id);
    own.push_back(*plane);
  }
  const auto plane = plane_of(scene, patch);
  const Vec3 a = scene.place(object.points[0]), b = scene.place(object.points[1]);
  const auto agrees = [&](const Vec3& place, const Plane& patch_plane) {
    return std::fabs(plane->distance(place)) < kOneFacade_m &&
           std::fabs(dot(plane->normal, patch_plane.normal)) > kOneFacadeCosine;
  };
  if (!plane || !agrees(a, own[0]) || !agrees(b, own[1]))
    return warn_of_target(scene, object, "its two targets are on no common plane: left out");
  for (const uint32_t i : free_points(
           scene,
           [&](const Vec3& p) {
             return std::fabs(plane->distance(p)) < object.row.distance_m &&
                    between(p, a, b, scene.settings.window_margin_m);
           },
           task))
    scene.owner[i] = number;
}

}  // namespace

void take_doors(TargetScene& scene, Task& task) {
  for (uint32_t number = 1; number <= scene.objects.objects.size(); ++number)
    if (scene.objects.objects[number - 1].row.geometry == CodeGeometry::kDoorTarget)
      take_door(scene, number, task);
}

void take_windows(TargetScene& scene, Task& task) {
  for (uint32_t number = 1; number <= scene.objects.objects.size(); ++number)
    if (scene.objects.objects[number - 1].row.geometry == CodeGeometry::kWindowTarget)
      take_facade(scene, number, task);
}

}  // namespace jalon
