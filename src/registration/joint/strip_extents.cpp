// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_extents.h"

#include <algorithm>

namespace jalon {

std::vector<StripExtent> strip_extents(const StripScene& scene) {
  std::vector<StripExtent> made(scene.strips.size());
  for (size_t t = 0; t < scene.face_of.size(); ++t) {
    const uint32_t s = scene.strip_of_face[scene.face_of[t]];
    if (s == kNoStrip) continue;
    for (size_t k = 0; k < 3; ++k) {
      const Vec3& c = scene.corners[3 * t + k];
      const double h = dot(along(scene.strips[s]), {c.x, c.y});
      made[s].from = std::min(made[s].from, h), made[s].to = std::max(made[s].to, h);
      made[s].bottom = std::min(made[s].bottom, c.z), made[s].top = std::max(made[s].top, c.z);
    }
  }
  return made;
}

std::vector<Vec3> strip_middles(const StripScene& scene, const std::vector<StripExtent>& extents) {
  std::vector<Vec3> made;
  for (size_t s = 0; s < extents.size(); ++s) {
    const GivenStrip& strip = scene.strips[s];
    const double place = extents[s].is_empty() ? 0 : (extents[s].from + extents[s].to) / 2;
    const Vec2 at = strip.normal * strip.offset_m + along(strip) * place;
    made.push_back({at.u, at.v, 0});
  }
  return made;
}

}  // namespace jalon
