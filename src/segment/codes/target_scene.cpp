// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/target_scene.h"

namespace jalon {

std::vector<uint32_t> patch_of(const TargetScene& scene, const CodedPoint& target, bool in_whole,
                               Task& task) {
  std::vector<Neighbour> found;
  scene.cloud.octree(task)->radius(target.position, scene.settings.patch_m, found);
  std::vector<uint32_t> patch;
  for (const Neighbour& n : found)
    if (in_whole || scene.owner[n.index] == 0) patch.push_back(n.index);
  return patch;
}

std::optional<Plane> plane_of(const TargetScene& scene, const std::vector<uint32_t>& points) {
  if (points.size() < 3) return std::nullopt;
  Moments moments;
  moments.reference = scene.local(points.front());
  for (const uint32_t i : points) moments.add(scene.local(i));
  PlaneFit fit;
  if (!fit_plane(moments, fit)) return std::nullopt;
  return fit.plane;
}

void warn_of_target(TargetScene& scene, const CodedObject& object, std::string text) {
  scene.objects.warnings.push_back({object.points.front().line, object.name, std::move(text)});
}

}  // namespace jalon
