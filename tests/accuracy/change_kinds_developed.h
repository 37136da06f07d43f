// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The kinds of scenes that the constants of the diagnosis were set on; the reported ones are others.

#include "change_kinds.h"

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

inline constexpr std::array<SceneKind, 8> kDevelopedChanges{{
    {"boxes come and go", boxes_come_and_go},
    {"boxes pushed", boxes_pushed},
    {"dented tank", dented_tank},
    {"beam and heave", beam_and_heave},
    {"panels", panels},
    {"unchanged yard", unchanged_yard},
    {"screens", screens},
    {"stacks", stacks},
}};

}  // namespace jalon::test
