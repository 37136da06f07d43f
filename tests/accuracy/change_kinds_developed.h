// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The kinds of scenes that the constants of the diagnosis were set on; the reported ones are others.

#include "change_kinds_unlike.h"

namespace jalon::test {

inline EpochScenes boxes_come_and_go(uint64_t seed) {
  SceneDice dice(seed, 1);
  EpochScenes out;
  yard(out, dice, seed);
  const std::vector<Vec3> at = dice.places();
  for (uint32_t k = 0; k < 6; ++k) {
    const Vec3 size = dice.size({0.3, 0.3, 0.2}, {0.8, 0.6, 0.9});
    const Transform place = placed(at[k].x, at[k].y, dice.turn_deg());
    const uint32_t object = kFirstThing + k;
    if (k < 4) out.before.box(size, place, object);
    if (k >= 2) out.after.box(size, place, object);
    if (k < 2) out.change(object, Happened::kWent, size.z);
    if (k >= 4) out.change(object, Happened::kCame, size.z);
  }
  return out;
}

inline EpochScenes boxes_pushed(uint64_t seed) {
  SceneDice dice(seed, 2);
  EpochScenes out;
  yard(out, dice, seed);
  const std::vector<Vec3> at = dice.places();
  for (uint32_t k = 0; k < 4; ++k) {
    const Vec3 size = dice.size({0.5, 0.35, 0.3}, {0.9, 0.6, 0.8});
    const Transform place = placed(at[k].x, at[k].y, dice.turn_deg());
    const double along = dice.between(0.2, 0.6) * size.x, turn = dice.sign() * dice.between(15, 60);
    const Transform motion = k == 0   ? placed(along, 0, 0)
                             : k == 1 ? placed(0, 0, turn)
                             : k == 2 ? placed(along / 2, along / 2, turn / 2)
                                      : Transform{};
    const uint32_t object = kFirstThing + k;
    out.before.box(size, place, object);
    out.after.box(size, place * motion, object);
    if (k < 3) out.change(object, Happened::kMoved, 0.2 * size.x);
  }
  return out;
}

inline EpochScenes dented_tank(uint64_t seed) {
  SceneDice dice(seed, 3);
  EpochScenes out;
  yard(out, dice, seed);
  const double dent = dice.between(0.05, 0.15), angle = dice.between(-2.4, -0.7);
  const double wide = dice.between(0.15, 0.3), up = dice.between(0.6, 1.4);
  const auto tank = [&](TriangleScene& s, double depth) {
    s.surface(90, 40, kFirstThing, [&](double u, double t) {
      const double a = 2 * std::numbers::pi * u, z = 2 * t;
      const double along = std::remainder(a - angle, 2 * std::numbers::pi), over = z - up;
      const double r = 0.9 - depth * std::exp(-(along * along + over * over) / (2 * wide * wide));
      return Vec3{r * std::cos(a), r * std::sin(a), z};
    });
  };
  tank(out.before, 0);
  tank(out.after, dent);
  out.change(kFirstThing, Happened::kGaveWay, dent);
  return out;
}

inline EpochScenes beam_and_heave(uint64_t seed) {
  SceneDice dice(seed, 4);
  EpochScenes out;
  set_up(out, dice);
  const FloorPatch flat{dice.between(-0.8, 0.8),
                        dice.between(-2, -1.2),
                        dice.between(0.5, 0.9),
                        dice.between(0.4, 0.7),
                        0,
                        kFirstThing};
  FloorPatch risen = flat;
  risen.height_m = dice.between(0.06, 0.2);
  const double sag = dice.between(0.15, 0.4), y = dice.between(1, 2), z = dice.between(1, 1.6);
  const auto beam = [&](TriangleScene& s, double bend) {
    for (int side = 0; side < 4; ++side)
      s.surface(40, 1, kFirstThing + 1, [&](double u, double t) {
        const double across = side < 2 ? (t - 0.5) * 0.2 : (side == 2 ? -0.1 : 0.1);
        const double over = side < 2 ? (side == 0 ? -0.1 : 0.1) : (t - 0.5) * 0.2;
        return Vec3{3 * u - 1.5, y + across, z - bend * u * u + over};
      });
  };
  for (const bool is_after : {false, true}) {
    TriangleScene& s = is_after ? out.after : out.before;
    floor_with(s, kYardHalf_m, is_after ? risen : flat, kFloor);
    wall(s, kWallAt_m, kYardHalf_m, kWallHeight_m, kWall);
    beam(s, is_after ? sag : 0);
  }
  clutter(out, dice, seed);
  out.change(kFirstThing, Happened::kGaveWay, risen.height_m);
  out.change(kFirstThing + 1, Happened::kGaveWay, sag);
  return out;
}

inline EpochScenes panels(uint64_t seed) {
  SceneDice dice(seed, 5);
  EpochScenes out;
  set_up(out, dice);
  std::vector<WallPanel> flush, off;
  for (uint32_t k = 0; k < 3; ++k) {
    const double x0 = -2.6 + 1.9 * k, low = dice.between(0.2, 0.8);
    const double wide = dice.between(0.8, 1.4), high = dice.between(0.6, 1.2);
    const double by = dice.sign() * dice.between(0.03, 0.09);
    flush.push_back({x0, x0 + wide, low, low + high, 0, kFirstThing + k});
    off.push_back(flush.back());
    if (k == 1) continue;
    off.back().off_m = by;
    out.change(kFirstThing + k, Happened::kGaveWay, std::abs(by));
  }
  const double pole = dice.between(-2.2, -1.6);
  for (const bool is_after : {false, true}) {
    TriangleScene& s = is_after ? out.after : out.before;
    s.ground(kYardHalf_m, kFloor);
    wall(s, kWallAt_m, kYardHalf_m, kWallHeight_m, kWall, is_after ? off : flush);
    tube(s, {pole, 2.4, 0}, 0.08, 2.2, kClutter + 3);
  }
  clutter(out, dice, seed);
  return out;
}

inline EpochScenes unchanged_yard(uint64_t seed) {
  SceneDice dice(seed, 6);
  EpochScenes out;
  yard(out, dice, seed);
  const std::vector<Vec3> at = dice.places();
  for (uint32_t k = 0; k < 5; ++k) {
    const Vec3 size = dice.size({0.3, 0.3, 0.2}, {0.9, 0.6, 1.2});
    const double turn = dice.turn_deg();
    out.both(
        [&](TriangleScene& s) { s.box(size, placed(at[k].x, at[k].y, turn), kFirstThing + k); });
  }
  return out;
}

/// What stood behind a screen comes into sight when that goes.
inline EpochScenes screens(uint64_t seed) {
  SceneDice dice(seed, 7);
  EpochScenes out;
  yard(out, dice, seed);
  const double x = dice.between(-1, 1), y = dice.between(-1.8, -1), turn = dice.between(-20, 20);
  const Vec3 size = dice.size({1.2, 0.3, 1.2}, {2, 0.5, 1.8});
  out.before.box(size, placed(x, y, turn), kFirstThing);
  out.change(kFirstThing, Happened::kWent, size.z);
  for (uint32_t k = 1; k < 4; ++k) {
    const Vec3 of = dice.size({0.4, 0.3, 0.5}, {0.8, 0.6, 1.2});
    const double beyond = dice.between(0.6, 2);
    const Transform place = placed(1.4 * k - 2.8, beyond, dice.turn_deg());
    if (k < 3) out.before.box(of, place, kFirstThing + k);
    out.after.box(of, place, kFirstThing + k);
    if (k == 3) out.change(kFirstThing + k, Happened::kCame, of.z);
  }
  return out;
}

/// The uppermost box of a stack goes, another stack gets one.
inline EpochScenes stacks(uint64_t seed) {
  SceneDice dice(seed, 8);
  EpochScenes out;
  yard(out, dice, seed);
  const std::vector<Vec3> at = dice.places();
  for (uint32_t k = 0; k < 4; ++k) {
    const Vec3 size = dice.size({0.5, 0.4, 0.25}, {0.8, 0.6, 0.45});
    const double turn = dice.turn_deg();
    for (uint32_t level = 0; level < 3; ++level) {
      const uint32_t object = kFirstThing + 3 * k + level;
      const Transform place = placed(at[k].x, at[k].y, turn + 4 * level, size.z * level);
      const bool changes = level == 2 && k < 3;
      if (!changes || k < 2) out.before.box(size, place, object);
      if (!changes || k == 2) out.after.box(size, place, object);
      if (changes) out.change(object, k < 2 ? Happened::kWent : Happened::kCame, size.z);
    }
  }
  return out;
}

/// A plank on two boards.
inline void bench(TriangleScene& scene, const Vec3& size, const Transform& place, uint32_t object) {
  constexpr double kPlank_m = 0.05, kBoard_m = 0.04;
  scene.box({size.x, size.y, kPlank_m}, place * placed(0, 0, 0, size.z - kPlank_m), object);
  for (const double x : {-0.4, 0.4})
    scene.box({kBoard_m, 0.9 * size.y, size.z - kPlank_m}, place * placed(x * size.x, 0, 0),
              object);
}

/// Two sides and the boards between them, open in front and behind.
inline void shelf(TriangleScene& scene, const Vec3& size, const Transform& place, uint32_t object) {
  constexpr double kBoard_m = 0.03;
  constexpr int kBoards = 4;
  for (const double x : {-0.5, 0.5})
    scene.box({kBoard_m, size.y, size.z}, place * placed(x * size.x, 0, 0), object);
  for (int k = 0; k < kBoards; ++k)
    scene.box({size.x - kBoard_m, size.y, kBoard_m},
              place * placed(0, 0, 0, (size.z - kBoard_m) * (k + 0.5) / (kBoards - 0.5)), object);
}

/// What one sees through and under: a part of it is hidden from everywhere, and another part after it was pushed.
inline EpochScenes benches_and_shelves(uint64_t seed) {
  SceneDice dice(seed, 9);
  EpochScenes out;
  yard(out, dice, seed);
  const std::vector<Vec3> at = dice.places();
  for (uint32_t k = 0; k < 4; ++k) {
    const bool is_bench = k % 2 == 0;
    const Vec3 size = is_bench ? dice.size({0.9, 0.3, 0.4}, {1.3, 0.5, 0.55})
                               : dice.size({0.6, 0.3, 0.8}, {0.9, 0.45, 1.3});
    const Transform place = placed(at[k].x, at[k].y, dice.turn_deg());
    const double along = dice.sign() * dice.between(0.1, 0.5), across = dice.between(-0.25, 0.25),
                 turn = dice.between(-45, 45);
    const uint32_t object = kFirstThing + k;
    const auto add = [&](TriangleScene& s, const Transform& to) {
      is_bench ? bench(s, size, to, object) : shelf(s, size, to, object);
    };
    add(out.before, place);
    add(out.after, k < 3 ? place * placed(along, across, turn) : place);
    if (k < 3) out.change(object, Happened::kMoved, std::abs(along));
  }
  return out;
}

/// Beside where one thing stood another one stands now, and one of another kind was carried off as it is.
inline EpochScenes exchanged(uint64_t seed) {
  SceneDice dice(seed, 10);
  EpochScenes out;
  yard(out, dice, seed);
  for (uint32_t k = 0; k < 3; ++k) {
    const Vec3 went = dice.size({0.4, 0.4, 0.4}, {0.8, 0.6, 0.9});
    const Vec3 came = dice.size({0.4, 0.3, 0.3}, {0.9, 0.7, 1});
    const double x = dice.between(-2.1, -1.7), y = 1.5 * k - 1.7 + dice.between(-0.1, 0.1);
    const double to_x = x + (went.x + came.x) / 2 + dice.between(0.2, 0.6);
    const double turn = dice.between(-15, 15), to_turn = dice.between(-15, 15);
    const uint32_t object = kFirstThing + 2 * k;
    out.before.box(went, placed(x, y, turn), object);
    if (k == 1) bench(out.after, came, placed(to_x, y, to_turn), object + 1);
    else out.after.box(came, placed(to_x, y, to_turn), object + 1);
    out.change(object, Happened::kWent, went.z);
    out.change(object + 1, Happened::kCame, came.z);
  }
  const Vec3 size = dice.size({0.4, 0.4, 0.4}, {0.9, 0.5, 0.9});
  const double x = dice.between(1, 1.6), y = dice.between(-1.6, -0.8), way = dice.between(0.6, 1);
  const double turn = dice.turn_deg(), to_turn = turn + dice.between(-60, 60);
  constexpr uint32_t kCarried = kFirstThing + 6;
  out.before.box(size, placed(x, y, turn), kCarried);
  out.after.box(size, placed(x, y + way, to_turn), kCarried);
  out.change(kCarried, Happened::kMoved, way);
  return out;
}

/// Of a fence of three boards that join, one leans over about its foot and another one bulges; a third stays.
inline EpochScenes fences(uint64_t seed) {
  SceneDice dice(seed, 11);
  EpochScenes out;
  set_up(out, dice);
  const double y = dice.between(0.2, 1.6), high = dice.between(1.2, 1.8);
  const double lean = dice.sign() * dice.between(0.04, 0.1), bulge = dice.between(0.06, 0.15);
  const auto leaning = static_cast<uint32_t>(dice.below(3));
  const uint32_t bulging = (leaning + 1 + static_cast<uint32_t>(dice.below(2))) % 3;
  for (const bool is_after : {false, true}) {
    TriangleScene& s = is_after ? out.after : out.before;
    s.ground(kYardHalf_m, kFloor);
    for (uint32_t k = 0; k < 3; ++k)
      s.surface(12, 12, kFirstThing + k, [&](double u, double t) {
        const double a = std::sin(std::numbers::pi * u), b = std::sin(std::numbers::pi * t);
        double off = 0;
        if (is_after && k == leaning) off = lean * high * t;
        if (is_after && k == bulging) off = bulge * a * a * b * b;
        return Vec3{2.0 * k - 3 + 2 * u, y - off, high * t};
      });
  }
  clutter(out, dice, seed);
  out.change(kFirstThing + leaning, Happened::kGaveWay, std::abs(lean) * high);
  out.change(kFirstThing + bulging, Happened::kGaveWay, bulge);
  return out;
}

inline constexpr std::array<SceneKind, 15> kDevelopedChanges{{
    {"boxes come and go", boxes_come_and_go},
    {"boxes pushed", boxes_pushed},
    {"dented tank", dented_tank},
    {"beam and heave", beam_and_heave},
    {"panels", panels},
    {"unchanged yard", unchanged_yard},
    {"screens", screens},
    {"stacks", stacks},
    {"benches and shelves", benches_and_shelves},
    {"exchanged", exchanged},
    {"fences", fences},
    {"unlike neighbours", unlike_neighbours},
    {"other sizes", other_sizes},
    {"walls give way", walls_give_way},
    {"growth", growth},
}};

// Fitted to as well. Things are looked for upright, so what fell over is often told as gone and come: a known limit.
inline constexpr std::array<SceneKind, 1> kFallenThings{{{"toppled", toppled}}};

}  // namespace jalon::test
