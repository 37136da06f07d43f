// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Plans and scenes of the grammar, and what its tests measure on them.

#include <algorithm>
#include <string_view>

#include "geometry/polygon2.h"
#include "scan/facade_truth.h"
#include "scan/grammar/plan.h"
#include "scan/grammar/sketch.h"
#include "unit/scan/scenes/built.h"

namespace jalon::test {

inline std::vector<FacadeKind> all_kinds() {
  std::vector<FacadeKind> out;
  for (int k = 1; k <= kFacadeKinds; ++k) out.push_back(static_cast<FacadeKind>(k));
  return out;
}

inline SceneSettings grammar_scene(FacadeKind kind, uint64_t seed, GrammarSettings settings = {}) {
  settings.kind = kind;
  return {.name = SceneName::kGrammar, .seed = seed, .grammar = settings};
}

inline grammar::Plan planned(FacadeKind kind, uint64_t seed, GrammarSettings settings = {}) {
  settings.kind = kind;
  return grammar::plan_facade(settings, seed);
}

inline Rect bounds_of_opening(const grammar::PlannedOpening& o) {
  return bounds_of(contour_of(o.shape));
}

inline size_t count_of_class(const grammar::Plan& plan, OpeningClass wanted) {
  size_t n = 0;
  for (const grammar::PlannedWall& wall : plan.walls)
    for (const grammar::PlannedOpening& o : wall.openings) n += o.opening_class == wanted;
  return n;
}

inline size_t count_of_pads(const grammar::Plan& plan, std::string_view part_class) {
  size_t n = 0;
  for (const grammar::PlannedWall& wall : plan.walls)
    for (const grammar::Pad& pad : wall.pads) n += pad.part_class == part_class;
  return n;
}

inline size_t openings_of(const grammar::Plan& plan) {
  size_t n = 0;
  for (const grammar::PlannedWall& wall : plan.walls) n += wall.openings.size();
  return n;
}

/// Openings lie in their walls, apart from each other; pads lie on their walls, beside openings and each other.
inline bool is_orderly(const grammar::Plan& plan) {
  const auto apart = [](const Rect& a, const Rect& b) {
    return a.u1 <= b.u0 || b.u1 <= a.u0 || a.v1 <= b.v0 || b.v1 <= a.v0;
  };
  for (const grammar::PlannedWall& wall : plan.walls) {
    const Outline outline = chords_of(wall.outline);
    for (size_t i = 0; i < wall.openings.size(); ++i) {
      const Rect box = bounds_of_opening(wall.openings[i]);
      for (const Vec2& p : chords_of(contour_of(wall.openings[i].shape)))
        if (!contains(outline, {p.u, p.v + 1e-6})) return false;
      for (size_t j = 0; j < i; ++j)
        if (!apart(box, bounds_of_opening(wall.openings[j]))) return false;
    }
    for (size_t i = 0; i < wall.pads.size(); ++i)
      for (size_t j = 0; j < i; ++j) {
        Rect box = bounds_of(wall.pads[i].outline);
        box = {box.u0 + 1e-6, box.u1 - 1e-6, box.v0 + 1e-6, box.v1 - 1e-6};
        if (!apart(box, bounds_of(wall.pads[j].outline))) return false;
      }
  }
  return true;
}

/// A sketch of a bare wall of 10 x 6 m with two storeys.
struct BareSketch {
  GrammarSettings settings;
  grammar::Plan plan;
  grammar::Dice dice{7, 1};
  grammar::Sketch sketch{settings, plan, dice};
  size_t wall;
  BareSketch() {
    plan.width_m = 10;
    sketch.storeys(2, 3, 3);
    wall = sketch.wall("wall 1", 0, contour_of(Rect{0, 10, 0, 6}));
  }
  grammar::PlannedWall& at() { return plan.walls[wall]; }
};

}  // namespace jalon::test
