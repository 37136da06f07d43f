// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <string>

#include "scan/scenes/scenes.h"

namespace jalon {

void build_room(const SceneSettings&, SceneBuilder& out) {
  constexpr double kLength = 6, kWidth = 5, kHeight = 2.8;
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const uint32_t room = out.part("room", "room");
  const uint32_t floor = out.part("floor", "floor", room),
                 ceiling = out.part("ceiling", "ceiling", room);
  const uint32_t walls = out.part("walls", "wall", room);
  out.face(floor, {{}, x, y}, {0, kLength, 0, kWidth});
  out.face(ceiling, {z * kHeight, y, x}, {0, kWidth, 0, kLength});
  out.face(walls, {{}, z, x}, {0, kHeight, 0, kLength});
  out.face(walls, {y * kWidth, x, z}, {0, kLength, 0, kHeight});
  out.face(walls, {{}, y, z}, {0, kWidth, 0, kHeight});
  out.face(walls, {x * kLength, z, y}, {0, kHeight, 0, kWidth});
}

void build_box(const SceneSettings&, SceneBuilder& out) {
  constexpr double kGround = 20;
  const Vec3 size{4.2, 1.8, 1.5};
  out.box(out.part("box", "box"), {-size.x / 2, -size.y / 2, 0}, size, false);
  const Rect foot{-size.x / 2, size.x / 2, -size.y / 2, size.y / 2};
  out.face(out.part("ground", "ground"), {{}, {1, 0, 0}, {0, 1, 0}},
           {-kGround / 2, kGround / 2, -kGround / 2, kGround / 2}, {&foot, 1});
}

void build_bow(const SceneSettings&, SceneBuilder& out) {
  constexpr double kRadius_m = 6, kHeight_m = 8, kHalfArc_rad = 70 * std::numbers::pi / 180;
  constexpr int kChords = 140;  // within 0.1 mm of the arc
  out.part("wall", "wall");
  Outline path;  // from right to left: its left side is the outer one
  for (int k = 0; k <= kChords; ++k) {
    const double angle = kHalfArc_rad * (1 - 2.0 * k / kChords);
    path.push_back({kRadius_m * std::sin(angle), kRadius_m * (1 - std::cos(angle))});
  }
  out.swept({{}, {1, 0, 0}, {0, 1, 0}}, path, 0, kHeight_m);
  out.face(out.part("ground", "ground"), {{}, {1, 0, 0}, {0, 1, 0}}, {-8, 8, -6, 0});
}

void build_strips(const SceneSettings&, SceneBuilder& out) {
  constexpr double kWidth = 1.5, kHeight = 8, kStep = 0.10;
  for (int k = 0; k < 6; ++k)
    out.face(out.part("strip " + std::to_string(k + 1), "wall"),
             {{kWidth * k, kStep * k, 0}, {1, 0, 0}, {0, 0, 1}}, {0, kWidth, 0, kHeight});
}

}  // namespace jalon
