// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "scan/scenes.h"

namespace jalon {

void build_room(SceneBuilder& out) {
  constexpr double kLength = 6, kWidth = 5, kHeight = 2.8;
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const uint32_t room = out.part("room", "room");
  const uint32_t floor = out.part("floor", "floor", room), ceiling = out.part("ceiling", "ceiling", room);
  const uint32_t walls = out.part("walls", "wall", room);
  out.face(floor, {{}, x, y}, {0, kLength, 0, kWidth});
  out.face(ceiling, {z * kHeight, y, x}, {0, kWidth, 0, kLength});
  out.face(walls, {{}, z, x}, {0, kHeight, 0, kLength});
  out.face(walls, {y * kWidth, x, z}, {0, kLength, 0, kHeight});
  out.face(walls, {{}, y, z}, {0, kWidth, 0, kHeight});
  out.face(walls, {x * kLength, z, y}, {0, kHeight, 0, kWidth});
}

void build_box(SceneBuilder& out) {
  constexpr double kGround = 20;
  const Vec3 size{4.2, 1.8, 1.5};
  out.box(out.part("box", "box"), {-size.x / 2, -size.y / 2, 0}, size, false);
  const Rect foot{-size.x / 2, size.x / 2, -size.y / 2, size.y / 2};
  out.face(out.part("ground", "ground"), {{}, {1, 0, 0}, {0, 1, 0}},
           {-kGround / 2, kGround / 2, -kGround / 2, kGround / 2}, {&foot, 1});
}

void build_surrounds(SceneBuilder& out) {
  constexpr double kWidth = 12, kHeight = 9;
  constexpr int kColumns = 4, kRows = 3;
  constexpr double kWindowWidth = 1.2, kWindowHeight = 1.8;
  constexpr double kSurround = 0.15, kSurroundOut = 0.06;  // width, and how far it stands before the wall
  constexpr double kJoinery = 0.08, kJoineryIn = 0.20;
  const Frame front{{}, {1, 0, 0}, {0, 0, 1}};
  const uint32_t house = out.part("facade", "facade");
  const uint32_t wall = out.part("wall", "wall", house);
  const auto grown = [](const Rect& r, double by) { return Rect{r.u0 - by, r.u1 + by, r.v0 - by, r.v1 + by}; };
  std::vector<Rect> windows, holes;
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i) {
      const double u = kWidth * (i + 0.5) / kColumns - kWindowWidth / 2,
                   v = kHeight * (j + 0.5) / kRows - kWindowHeight / 2;
      windows.push_back({u, u + kWindowWidth, v, v + kWindowHeight});
      holes.push_back(grown(windows.back(), kSurround));
    }
  out.face(wall, front, {0, kWidth, 0, kHeight}, holes);
  for (size_t w = 0; w < windows.size(); ++w) {
    const uint32_t window = out.part("window " + std::to_string(w + 1), "window", wall);
    out.face(out.part("surround", "surround", window), front.raised(kSurroundOut), holes[w], {&windows[w], 1});
    const Rect inner = grown(windows[w], -kJoinery);
    out.face(out.part("joinery", "joinery", window), front.raised(-kJoineryIn), windows[w], {&inner, 1});
  }
}

void build_strips(SceneBuilder& out) {
  constexpr double kWidth = 1.5, kHeight = 8, kStep = 0.10;
  for (int k = 0; k < 6; ++k)
    out.face(out.part("strip " + std::to_string(k + 1), "wall"), {{kWidth * k, kStep * k, 0}, {1, 0, 0}, {0, 0, 1}},
             {0, kWidth, 0, kHeight});
}

}  // namespace jalon
