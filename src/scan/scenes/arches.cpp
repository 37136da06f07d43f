// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// After Boulaassal 2010, 4.5 and 5.6.3.2: windows with round heads.
#include <cmath>
#include <string>
#include <vector>

#include "scan/builder/objects.h"
#include "scan/scenes/scenes.h"

namespace jalon {

namespace {

constexpr Vec3 kArchesX{1, 0, 0}, kArchesZ{0, 0, 1};

/// An opening; flat when it does not rise.
struct Window {
  Rect rect;
  double rise_m, depth_m;
};

void add_wall(SceneBuilder& out, uint32_t wall, const Frame& frame, double width, double height,
              const std::vector<Window>& windows) {
  std::vector<Outline> openings;
  for (const Window& w : windows)
    openings.push_back(w.rise_m > 0 ? arched_outline(w.rect, w.rise_m) : outline_of(w.rect));
  out.polygon_face(wall, frame, outline_of({0, width, 0, height}), openings);
}

/// A stone sill below the opening: front, top as far as the wall, underside, ends.
void add_sill(SceneBuilder& out, uint32_t window, const Frame& frame, const Rect& opening) {
  constexpr double kHeight_m = 0.10, kWidth_m = 1.4, kOut_m = 0.12;
  const uint32_t sill = out.part("sill", "sill", window);
  const double u0 = opening.u0 + opening.width() / 2 - kWidth_m / 2, u1 = u0 + kWidth_m;
  const double v0 = opening.v0 - kHeight_m, v1 = opening.v0;
  const Vec3 n = frame.normal();
  out.face(sill, frame.raised(kOut_m), {u0, u1, v0, v1});
  out.face(sill, {frame.point(u0, v1), n, frame.u}, {0, kOut_m, 0, kWidth_m});
  out.face(sill, {frame.point(u0, v0), frame.u, n}, {0, kWidth_m, 0, kOut_m});
  out.face(sill, {frame.point(u0, v0), n, frame.v}, {0, kOut_m, 0, kHeight_m});
  out.face(sill, {frame.point(u1, v0), frame.v, n}, {0, kHeight_m, 0, kOut_m});
}

/// Facade 1: windows 1-4 with segmental heads, above them 5-8 with semicircular ones.
std::vector<Window> lycee_windows() {
  constexpr double kBay_m = 3.5, kWidth_m = 1.2, kHeight_m = 2.0;
  constexpr double kSill_m[] = {5, 10}, kRise_m[] = {0.20, 0.60}, kDepth_m[] = {0.20, 0.25};
  std::vector<Window> out;
  for (size_t j = 0; j < 2; ++j)
    for (int i = 0; i < 4; ++i) {
      const double u = kBay_m * (i + 0.5) - kWidth_m / 2;
      out.push_back(
          {{u, u + kWidth_m, kSill_m[j], kSill_m[j] + kHeight_m}, kRise_m[j], kDepth_m[j]});
    }
  return out;
}

}  // namespace

void build_lycee(const SceneSettings& settings, SceneBuilder& out) {
  // 1. A chain of six walls in plan; corners of 135, 90, 135, 90 and 135 degrees.
  constexpr double kHeight_m = 15, kTurn = 0.78539816339744831;  // 45 degrees
  constexpr double kWidth_m[] = {14, 8, 10, 20, 6, 12};
  constexpr int kHeading[] = {0, 1, -1, 0, 2, 1};
  Vec3 corner;
  for (size_t i = 0; i < 6; ++i) {
    const Vec3 along{std::cos(kTurn * kHeading[i]), std::sin(kTurn * kHeading[i]), 0};
    const Frame frame{corner, along, kArchesZ};
    const uint32_t wall =
        out.part("wall", "wall", out.part("facade " + std::to_string(i + 1), "facade"));
    const std::vector<Window> windows = i == 0 ? lycee_windows() : std::vector<Window>{};
    add_wall(out, wall, frame, kWidth_m[i], kHeight_m, windows);
    for (size_t w = 0; w < windows.size(); ++w) {
      const uint32_t window = out.part("window " + std::to_string(w + 1), "window", wall);
      out.arched_recess(window, frame, windows[w].rect, windows[w].rise_m, windows[w].depth_m,
                        true);
      add_sill(out, window, frame, windows[w].rect);
    }
    corner += along * kWidth_m[i];
  }
  // 2. Two crowns 4 m in front: from a tripod at (7, -16, 1.7) they stand before windows 5, and 7 and 8.
  constexpr double kCrown_m = 2, kOpacity = 0.75;
  const uint64_t seed = settings.seed;
  const uint32_t unwanted = out.part("unwanted", "unwanted");
  add_crown(out, unwanted, {3.06, -4, 8.7}, kCrown_m, kOpacity, {seed, 1});
  add_crown(out, unwanted, {9.63, -4, 8.7}, kCrown_m, kOpacity, {seed, 2});
}

void build_arches(const SceneSettings&, SceneBuilder& out) {
  // Two walls, 96 and 33.6 m2 with their openings; windows of 2.56 m2, three of them with a semicircular head.
  constexpr double kDepth_m = 0.15;
  struct Wall {
    Vec3 corner;
    double width_m, height_m;
    std::vector<Window> windows;
  };
  const auto square = [](double u, double v) {
    return Window{{u, u + 1.6, v, v + 1.6}, 0, kDepth_m};
  };
  const auto arched = [](double u, double v) {
    return Window{{u, u + 1.2, v, v + 2.2}, 0.6, kDepth_m};
  };
  const Wall kWalls[] = {{{0, 0, 0},
                          8,
                          12,
                          {square(1.5, 1.2), square(4.9, 1.2), square(1.5, 4.8), square(4.9, 4.8),
                           arched(1.7, 8.4), arched(5.1, 8.4)}},
                         {{9, 0.4, 0}, 4.2, 8, {square(1.3, 1.2), arched(1.5, 4.8)}}};
  for (const Wall& w : kWalls) {
    const uint32_t wall = out.part("wall", "wall", out.part("facade", "facade"));
    const Frame frame{w.corner, kArchesX, kArchesZ};
    add_wall(out, wall, frame, w.width_m, w.height_m, w.windows);
    for (size_t i = 0; i < w.windows.size(); ++i) {
      const Window& opening = w.windows[i];
      const uint32_t window = out.part("window " + std::to_string(i + 1), "window", wall);
      if (opening.rise_m > 0)
        out.arched_recess(window, frame, opening.rect, opening.rise_m, opening.depth_m, false);
      else out.recess(window, frame, opening.rect, opening.depth_m, true, 0);
    }
  }
}

}  // namespace jalon
