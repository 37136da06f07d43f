// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "unit/modelling/planned_scene.h"

// Openings of every day, drawn by hand: two storeys of three windows, a door, a shop front.
namespace planned {

inline FacadeOpening filled(const Vec2& low, const Vec2& high, double depth_m,
                            const OpeningContent& content) {
  FacadeOpening out = opening_at(low, high, depth_m, OpeningKind::kOpening);
  out.content = content;
  return out;
}

inline constexpr OpeningContent kGlazed{0.4, 0.3, 0.4}, kLeaf{0.95, 0, 0.05};

// Two storeys of three windows, a door, and a shop front on the ground.
inline PlannedScene street_house() {
  PlannedScene scene;
  std::vector<FacadeOpening> openings;
  for (const double v : {3.9, 6.9})
    for (const double u : {1.0, 4.0, 7.0})
      openings.push_back(filled({u, v}, {u + 1.2, v + 1.5}, 0.15, kGlazed));
  openings.push_back(filled({1.1, 0}, {2.1, 2.2}, 0.2, kLeaf));
  openings.push_back(filled({4, 0}, {8.2, 2.7}, 0.15, kGlazed));
  openings.back().is_notch = openings[6].is_notch = true;
  scene.add_wall({0, 0}, {10, 10}, openings);
  return scene;
}

}  // namespace planned
