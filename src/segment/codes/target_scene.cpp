// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/target_scene.h"

namespace jalon {

std::vector<uint32_t> patch_of(const TargetScene& scene, const CodedPoint& target, bool in_whole) {
  const Vec3 centre = scene.place(target);
  const double radius = scene.settings.patch_m;
  std::vector<uint32_t> patch;
  for (const uint32_t i : scene.tiles.points_about(in_plan(centre), radius))
    if (squared_norm(scene.local(i) - centre) <= radius * radius &&
        (in_whole || scene.owner[i] == 0))
      patch.push_back(i);
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
