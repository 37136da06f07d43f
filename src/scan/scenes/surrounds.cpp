// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// After Boulaassal 2010, 3.3 and 3.4.3.6: a wall with window surrounds, alone and behind what nobody wants.
#include <algorithm>
#include <string>
#include <vector>

#include "scan/builder/objects.h"
#include "scan/scenes/scenes.h"

namespace jalon {

namespace {

constexpr double kSurroundsWidth_m = 12, kHeight_m = 9;
constexpr int kColumns = 4, kRows = 3;
constexpr double kSurroundsWindowWidth_m = 1.2, kWindowHeight_m = 1.8;
constexpr double kSurround_m = 0.15,
                 kSurroundOut_m = 0.06;  // width, and how far it stands before the wall
constexpr double kJoinery_m = 0.08, kJoineryIn_m = 0.20;
constexpr double kSurroundsGlassBehind_m = 0.02;  // behind the joinery, of S3
const Frame kSurroundsFront{{}, {1, 0, 0}, {0, 0, 1}};

Rect grown(const Rect& r, double by) { return {r.u0 - by, r.u1 + by, r.v0 - by, r.v1 + by}; }

std::vector<Rect> windows() {
  std::vector<Rect> out;
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i) {
      const double u = kSurroundsWidth_m * (i + 0.5) / kColumns - kSurroundsWindowWidth_m / 2,
                   v = kHeight_m * (j + 0.5) / kRows - kWindowHeight_m / 2;
      out.push_back({u, u + kSurroundsWindowWidth_m, v, v + kWindowHeight_m});
    }
  return out;
}

void add_house(SceneBuilder& out, double glass_behind_m) {
  const uint32_t house = out.part("facade", "facade");
  const uint32_t wall = out.part("wall", "wall", house);
  const std::vector<Rect> list = windows();
  std::vector<Rect> holes;
  for (const Rect& w : list) holes.push_back(grown(w, kSurround_m));
  out.face(wall, kSurroundsFront, {0, kSurroundsWidth_m, 0, kHeight_m}, holes);
  for (size_t w = 0; w < list.size(); ++w) {
    const uint32_t window = out.part("window " + std::to_string(w + 1), "window", wall);
    out.face(out.part("surround", "surround", window), kSurroundsFront.raised(kSurroundOut_m),
             holes[w], {&list[w], 1});
    const Rect inner = grown(list[w], -kJoinery_m);
    const Frame back = kSurroundsFront.raised(-kJoineryIn_m);
    out.face(out.part("joinery", "joinery", window), back, list[w], {&inner, 1});
    if (glass_behind_m > 0)
      out.face(out.part("glass", "glass", window), back.raised(-glass_behind_m), inner);
  }
}

/// Furniture behind each window, 0.8 to 6 m from the wall: upright sheets that are seen through the glass.
void add_ghosts(SceneBuilder& out, uint32_t parent, uint64_t seed) {
  constexpr int kSheets = 3;
  constexpr double kNearest_m = 0.8, kFarthest_m = 6, kAside_m = 1;
  uint64_t number = 0;
  for (const Rect& window : windows()) {
    const uint32_t ghosts = out.part("ghosts", "ghost", parent);
    for (int k = 0; k < kSheets; ++k) {
      RandomStream random(seed, ++number);
      const double behind = kNearest_m + (kFarthest_m - kNearest_m) * random.uniform();
      const double u = window.u0 + window.width() / 2 + kAside_m * (2 * random.uniform() - 1);
      const double width = 0.4 + 0.8 * random.uniform(), height = 0.5 + random.uniform();
      const double v = std::min(window.v0 + window.height() * random.uniform(), kHeight_m - height);
      out.face(ghosts, kSurroundsFront.raised(-behind),
               {u - width / 2, u + width / 2, v, v + height});
    }
  }
}

}  // namespace

void build_surrounds(const SceneSettings& settings, SceneBuilder& out) {
  add_house(out, settings.glass_m);
}

void build_unwanted(const SceneSettings& settings, SceneBuilder& out) {
  constexpr double kCrown_m = 1.5, kOpacity = 0.9;
  const uint64_t seed = settings.seed;
  add_house(out, kSurroundsGlassBehind_m);
  const uint32_t unwanted = out.part("unwanted", "unwanted");
  add_tree(out, unwanted, {2, -5.5, 3.2}, kCrown_m, kOpacity, {seed, 1u << 30});
  add_tree(out, unwanted, {6.5, -4.6, 4.0}, kCrown_m, kOpacity, {seed, (1u << 30) + 1});
  add_tree(out, unwanted, {10.5, -5, 3.5}, kCrown_m, kOpacity, {seed, (1u << 30) + 2});
  add_car(out, unwanted, {0.5, -2.9, 0}, 4.2);
  add_car(out, unwanted, {7.2, -3.0, 0}, 4.2);
  add_pedestrian(out, unwanted, {5.6, -1.5, 0});
  add_pedestrian(out, unwanted, {6.2, -2.5, 0});
  add_ghosts(out, unwanted, seed);
}

}  // namespace jalon
