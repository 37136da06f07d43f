// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Deformation without overlap: dents, bulges, sags and breaks that are deeper than what gave way is thick, so that the
// new surface has no points in common with the old one, each beside a thing that was pushed, came or went. Developed on
// some seeds, reported on others.

#include "change_kinds.h"

namespace jalon::test {

/// 1 in the middle of a span, 0 at its ends, joined without a fold.
inline double plateau(double at) {
  constexpr double kEdge = 0.35;  // of the span, to either side
  const double t = std::min(1.0, std::min(at, 1 - at) / kEdge);
  return t * t * (3 - 2 * t);
}

/// A sheet between two posts, in its own axes: x along it, y before it. Its middle is off by depth_m.
inline void hoarding(TriangleScene& s, const Vec3& size, const Transform& place, double depth_m,
                     uint32_t object) {
  for (const double x : {-0.5, 0.5})
    s.box({0.07, 0.07, size.z}, place * placed(x * size.x, 0, 0), kClutter + 3);
  s.surface(28, 20, object, [&](double u, double t) {
    return place.point({size.x * (u - 0.5), -depth_m * plateau(u) * plateau(t), size.z * t});
  });
}

/// A rail of a square section on two stands, in the shape of a V as deep as it is broken.
inline void broken_rail(TriangleScene& s, const Vec3& size, const Transform& place, double depth_m,
                        uint32_t object) {
  for (const double x : {-0.5, 0.5})
    s.box({0.1, 0.1, size.z - size.y}, place * placed(x * size.x, 0, 0), kClutter + 4);
  for (int side = 0; side < 4; ++side)
    s.surface(24, 1, object, [&](double u, double t) {
      const double across = (side < 2 ? t - 0.5 : side - 2.5) * size.y;
      const double over = (side < 2 ? side - 0.5 : t - 0.5) * size.y;
      const double down = depth_m * (1 - std::abs(2 * u - 1));
      return place.point({size.x * (u - 0.5), across, size.z - size.y / 2 + over - down});
    });
}

/// A hoarding dented by more than a car's bumper, a canvas roof that hangs through, and a crate that was pushed.
inline EpochScenes deep_dents(uint64_t seed) {
  SceneDice dice(seed, 17);
  EpochScenes out;
  yard(out, dice, seed);
  const Vec3 sheet = dice.size({1.5, 0, 1.3}, {2.1, 0, 1.8});
  const double dent = dice.sign() * dice.between(0.25, 0.6), turn = dice.between(-25, 25);
  const double sheet_x = dice.between(-1.9, -1.5), sheet_y = dice.between(-0.3, 0.9);
  const Vec3 roof = dice.size({1.4, 0.8, 1.3}, {2, 1.2, 1.7});
  const double taut = dice.between(0.02, 0.08), hangs = taut + dice.between(0.25, 0.55);
  const Transform over = placed(1.3, dice.between(0.6, 1.4), dice.between(-25, 25));
  const Vec3 crate = dice.size({0.5, 0.4, 0.4}, {0.8, 0.6, 0.7});
  const double pushed = dice.between(0.3, 1.2) * crate.x, to = dice.between(-30, 30);
  const Transform at = placed(dice.between(0.4, 1.2), dice.between(-1.9, -1.3), dice.turn_deg());
  for (const bool is_after : {false, true}) {
    TriangleScene& s = is_after ? out.after : out.before;
    hoarding(s, sheet, placed(sheet_x, sheet_y, turn), is_after ? dent : 0, kFirstThing);
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        s.box({0.06, 0.06, roof.z}, over * placed(x * roof.x, y * roof.y, 0), kClutter + 4);
    s.surface(28, 12, kFirstThing + 1, [&](double u, double t) {
      const double down = 4 * u * (1 - u) * (is_after ? hangs : taut);
      return over.point({roof.x * (u - 0.5), roof.y * (t - 0.5), roof.z - down});
    });
    s.box(crate, is_after ? at * placed(pushed, 0, to) : at, kFirstThing + 2);
  }
  out.change(kFirstThing, Happened::kGaveWay, std::abs(dent));
  out.change(kFirstThing + 1, Happened::kGaveWay, hangs - taut);
  out.change(kFirstThing + 2, Happened::kMoved, pushed);
  return out;
}

/// A tank crushed to an oval, a rail that broke in the middle, one box that came and one that went.
inline EpochScenes deep_breaks(uint64_t seed) {
  SceneDice dice(seed, 18);
  EpochScenes out;
  yard(out, dice, seed);
  const Vec3 rail = dice.size({1.5, 0.08, 1.1}, {2.1, 0.14, 1.5});
  const double broken = dice.between(0.3, 0.6), rail_turn = dice.between(-30, 30);
  const double rail_y = dice.between(0.8, 1.6);
  const double radius = dice.between(0.45, 0.7), high = dice.between(1, 1.5),
               crushed = dice.between(0.25, 0.4), tank_turn = dice.turn_deg();
  const Vec3 came = dice.size({0.4, 0.3, 0.3}, {0.8, 0.6, 0.9}),
             went = dice.size({0.4, 0.3, 0.3}, {0.8, 0.6, 0.9});
  const Transform came_at = placed(0.3, dice.between(-2, -1.5), dice.turn_deg()),
                  went_at = placed(2, dice.between(-1.6, -0.6), dice.turn_deg());
  for (const bool is_after : {false, true}) {
    TriangleScene& s = is_after ? out.after : out.before;
    broken_rail(s, rail, placed(1.2, rail_y, rail_turn), is_after ? broken : 0, kFirstThing);
    s.surface(60, 1, kFirstThing + 1, [&](double u, double t) {
      const double a = 2 * std::numbers::pi * u, by = is_after ? crushed : 0;
      const Vec3 p{radius * (1 + by / 2) * std::cos(a), radius * (1 - by) * std::sin(a), high * t};
      return placed(-1.6, -0.4, tank_turn).point(p);
    });
  }
  out.after.box(came, came_at, kFirstThing + 2);
  out.before.box(went, went_at, kFirstThing + 3);
  out.change(kFirstThing, Happened::kGaveWay, broken);
  out.change(kFirstThing + 1, Happened::kGaveWay, crushed * radius);
  out.change(kFirstThing + 2, Happened::kCame, came.z);
  out.change(kFirstThing + 3, Happened::kWent, went.z);
  return out;
}

inline constexpr std::array<SceneKind, 2> kDeepDeformations{{
    {"deep dents", deep_dents},
    {"deep breaks", deep_breaks},
}};

}  // namespace jalon::test
