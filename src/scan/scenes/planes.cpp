// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Small scenes of the segmentation's acceptance tests (after Boulaassal 2010, 3.4): std, normal,
// patches, sills, robbery. All stand on y = 0 and look along -Y unless they say otherwise.
#include <string>

#include "scan/scenes/scenes.h"

namespace jalon {

namespace {

constexpr Vec3 kPlanesX{1, 0, 0}, kPlanesY{0, 1, 0}, kPlanesZ{0, 0, 1};
const Frame kPlanesFront{{}, kPlanesX, kPlanesZ};
constexpr double kWallWidth_m = 10, kPlanesWallHeight_m = 6;  // of sills and robbery

}  // namespace

void build_std(const SceneSettings&, SceneBuilder& out) {
  // Six upright planes that look forward, two that look sideways, two that look up: 1 to 24 m2, none near another.
  struct Piece {
    Frame frame;
    double width_m, height_m;
  };
  const Piece kPieces[] = {{{{0, 0, 0}, kPlanesX, kPlanesZ}, 6, 4},
                           {{{7, 0.3, 0}, kPlanesX, kPlanesZ}, 4, 4},
                           {{{12, 0.6, 0}, kPlanesX, kPlanesZ}, 3, 3},
                           {{{16, 0.9, 0}, kPlanesX, kPlanesZ}, 2, 3.5},
                           {{{0, 1.2, 5}, kPlanesX, kPlanesZ}, 5, 1},
                           {{{6, 1.5, 5}, kPlanesX, kPlanesZ}, 1, 1},
                           {{{20, -3, 0}, kPlanesZ, kPlanesY}, 4, 2},
                           {{{22, -3, 0}, kPlanesZ, kPlanesY}, 2, 1},
                           {{{8, -4, -1}, kPlanesX, kPlanesY}, 4, 2.5},
                           {{{14, -4, -0.5}, kPlanesX, kPlanesY}, 1.5, 1.5}};
  int number = 0;
  for (const Piece& p : kPieces)
    out.face(out.part("plane " + std::to_string(++number), "wall"), p.frame,
             {0, p.width_m, 0, p.height_m});
}

void build_normal(const SceneSettings&, SceneBuilder& out) {
  out.face(out.part("plane", "wall"), kPlanesFront, {0, 10, 0, 10});
}

void build_patches(const SceneSettings&, SceneBuilder& out) {
  for (int k = 0; k < 2; ++k)
    out.face(out.part("patch " + std::to_string(k + 1), "wall"), kPlanesFront,
             {4.0 * k, 4.0 * k + 3, 0, 3});
}

void build_sills(const SceneSettings& settings, SceneBuilder& out) {
  constexpr double kSillHeight_m = 1.0, kSillDepth_m = 0.3;
  constexpr double kSillFrom_m[] = {2, 7}, kSillWidth_m = 1;  // 4 m apart
  const double gap = settings.gap_m;
  const uint32_t wall = out.part("wall", "wall");
  out.face(wall, kPlanesFront, {0, kWallWidth_m, 0, kPlanesWallHeight_m});
  for (const double from : kSillFrom_m)
    out.face(out.part("sill", "sill", wall), {{from, -gap, kSillHeight_m}, kPlanesX, kPlanesY},
             {0, kSillWidth_m, -kSillDepth_m, 0});
}

void build_robbery(const SceneSettings& settings, SceneBuilder& out) {
  constexpr double kShelfHeight_m = 3;
  const double depth = settings.depth_m, behind = settings.crossing ? depth / 2 : 0;
  const uint32_t wall = out.part("wall", "wall");
  out.face(wall, kPlanesFront, {0, kWallWidth_m, 0, kPlanesWallHeight_m});
  out.face(out.part("shelf", "band", wall), {{0, 0, kShelfHeight_m}, kPlanesX, kPlanesY},
           {0, kWallWidth_m, behind - depth, behind});
}

}  // namespace jalon
