// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The street of the measurements with other programs: sizes and places are those of their scene generator.
#include <cmath>
#include <string>
#include <vector>

#include "scan/scenes/scenes.h"

namespace jalon {

namespace {

constexpr int kStreetFacets = 96;  // chords stay within 0.14 mm of a 0.25 m column
constexpr double kSillHeight_m = 1.2;

struct StreetFacade {
  Vec3 corner, along;
  double height_m;
  int columns, rows;
  double window_width_m, window_height_m, depth_m;
};

/// What changed in the second epoch: a rectangle of a facade moved along its normal.
struct Patch {
  size_t facade;
  Rect rect;
  double moved_m;
};
constexpr Patch kPatches[] = {{0, {4, 10, 0.05, 1.15}, 0.005},
                              {1, {4, 10, 0.05, 1.15}, 0.020},
                              {2, {4, 10, 0.05, 1.15}, 0.100},
                              {3, {4, 10, 0.05, 1.15}, -0.020},
                              {4, {2, 18, 0.05, 1.15}, 0.005}};
constexpr double kFacadeWidth_m = 20;

std::vector<StreetFacade> facades() {
  constexpr double kHeight_m[] = {12, 15, 18, 14, 12, 16};
  constexpr double kOffset_m[] = {0, 0.35, -0.25, 0.2, 0, -0.3};
  constexpr double kDepth_m[] = {0.18, 0.25, 0.12, 0.2, 0.15, 0.22};
  std::vector<StreetFacade> out;
  for (int i = 0; i < 6; ++i) {
    const bool north = i < 3;
    const int rows = kHeight_m[i] < 13 ? 3 : 4;
    if (north)
      out.push_back({{20.0 * i, 8 + kOffset_m[i], 0},
                     {1, 0, 0},
                     kHeight_m[i],
                     6,
                     rows,
                     1.2,
                     1.6,
                     kDepth_m[i]});
    else
      out.push_back({{20.0 * (i - 3) + 20, -8 - kOffset_m[i], 0},
                     {-1, 0, 0},
                     kHeight_m[i],
                     7,
                     rows,
                     1.1,
                     1.7,
                     kDepth_m[i]});
  }
  return out;
}

void add_facade(SceneBuilder& out, size_t number, const StreetFacade& f, bool second_epoch) {
  const std::string name = "facade " + std::to_string(number + 1);
  const uint32_t house = out.part(name, "facade");
  const uint32_t wall = out.part("wall", "wall", house);
  const Frame frame{f.corner, f.along, {0, 0, 1}};
  const double gap_u = (kFacadeWidth_m - f.columns * f.window_width_m) / (f.columns + 1);
  const double gap_v = (f.height_m - kSillHeight_m - f.rows * f.window_height_m) / f.rows;
  std::vector<Rect> windows;
  for (int k = 0; k < f.rows; ++k)
    for (int i = 0; i < f.columns; ++i) {
      const double u = gap_u + i * (gap_u + f.window_width_m),
                   v = kSillHeight_m + k * (f.window_height_m + gap_v);
      windows.push_back({u, u + f.window_width_m, v, v + f.window_height_m});
    }
  std::vector<Rect> holes = windows;
  for (const Patch& patch : kPatches)
    if (second_epoch && patch.facade == number) holes.push_back(patch.rect);
  out.face(wall, frame, {0, kFacadeWidth_m, 0, f.height_m}, holes);
  const uint32_t glass = out.new_id();  // one plane of glass a facade, as in the measurements
  for (size_t w = 0; w < windows.size(); ++w)
    out.recess(out.part("window " + std::to_string(w + 1), "window", wall), frame, windows[w],
               f.depth_m, true, 0, glass);
  for (const Patch& patch : kPatches)
    if (second_epoch && patch.facade == number)
      out.face(out.part("patch", "change", wall), frame.raised(patch.moved_m), patch.rect);
}

}  // namespace

void build_street(const SceneSettings& settings, SceneBuilder& out) {
  const bool second_epoch = settings.epoch == 2;
  out.face(out.part("ground", "ground"), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 60, -8, 8});
  const std::vector<StreetFacade> list = facades();
  for (size_t i = 0; i < list.size(); ++i) add_facade(out, i, list[i], second_epoch);

  out.part("columns", "column");
  for (int i = 0; i < 6; ++i) {
    out.cylinder({3.0 + 10 * i, 7.0, 0}, 0.25, 4.0, kStreetFacets);
    out.cylinder({3.0 + 10 * i, -6.8, 0}, 0.20, 3.5, kStreetFacets);
  }
  out.part("gutters", "pipe");
  for (int i = 0; i < 4; ++i) {
    out.cylinder({20.0 * i, 7.6, 0}, 0.06, 11.5, kStreetFacets);
    out.cylinder({20.0 * i, -7.55, 0}, 0.05, 11.5, kStreetFacets);
  }
  const uint32_t boxes = out.part("boxes", "box");
  out.box(boxes, {10, 2.5, 0}, {4.2, 1.8, 1.5}, false);
  out.box(boxes, {48, 3, 0}, {4.0, 1.7, 1.6}, false);
  if (second_epoch) {
    out.box(boxes, {22, -4.6, 0}, {4.2, 1.8, 1.5}, false);
    out.cylinder({27, 4, 0}, 0.10, 6, kStreetFacets);
  } else {
    out.box(boxes, {32, -4.5, 0}, {4.4, 1.8, 1.4}, false);
  }
  out.part("sphere", "sphere");
  out.sphere({54, -2, 0.9}, 0.9, kStreetFacets);
}

}  // namespace jalon
