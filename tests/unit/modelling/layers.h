// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Walls, panes and rooms as layers of points on planes y = depth.
#pragma once

#include <vector>

#include "modelling/evidence/evidence.h"
#include "unit/modelling/walls.h"

namespace layers {

using namespace jalon;

constexpr double kStep_m = 0.05;

inline void add_layer(std::vector<Vec3>& out, double left, double foot, double width, double height,
                      double depth_m) {
  for (double u = left + kStep_m / 2; u < left + width; u += kStep_m)
    for (double v = foot + kStep_m / 2; v < foot + height; v += kStep_m)
      out.push_back({u, depth_m, v});
}

inline bool in_box(const Vec3& p, double left, double foot, double width, double height) {
  return p.x > left && p.x < left + width && p.z > foot && p.z < foot + height;
}

inline void cut(std::vector<Vec3>& points, double left, double foot, double width, double height) {
  std::erase_if(points, [&](const Vec3& p) { return in_box(p, left, foot, width, height); });
}

/// parts: those of the segments; rest: points of none.
inline std::vector<WallEvidence> evidence_of(const std::vector<std::vector<Vec3>>& parts,
                                             unsigned threads = 1,
                                             const std::vector<Vec3>& rest = {}) {
  std::vector<std::vector<Vec3>> all = parts;
  if (!rest.empty()) all.push_back(rest);
  Segmentation segmentation = walls::segmentation_of(all);
  for (size_t s = 0; s < all.size(); ++s)
    segmentation.segments[s].area_m2 =
        s < parts.size() ? kStep_m * kStep_m * static_cast<double>(parts[s].size()) : 0;
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return gather_evidence(segmentation, {}, task);
}

}  // namespace layers
