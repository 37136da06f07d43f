// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The kinds of scenes that figures are reported on; no constant of the diagnosis was set on them.

#include "change_kinds.h"

namespace jalon::test {

inline EpochScenes poles_and_barrels(uint64_t seed) {
  SceneDice dice(seed, 21);
  EpochScenes out;
  yard(out, dice, seed);
  const std::vector<Vec3> at = dice.places();
  for (uint32_t k = 0; k < 6; ++k) {
    const bool is_pole = k % 2 == 0;
    const double radius = is_pole ? dice.between(0.05, 0.12) : dice.between(0.25, 0.4);
    const double height = is_pole ? dice.between(1.2, 2.2) : dice.between(0.6, 1);
    const uint32_t object = kFirstThing + k;
    if (k < 4) tube(out.before, at[k], radius, height, object);
    if (k >= 2) tube(out.after, at[k], radius, height, object);
    if (k < 2) out.change(object, Happened::kWent, height);
    if (k >= 4) out.change(object, Happened::kCame, height);
  }
  return out;
}

inline EpochScenes tables_moved(uint64_t seed) {
  SceneDice dice(seed, 22);
  EpochScenes out;
  yard(out, dice, seed);
  const std::vector<Vec3> at = dice.places();
  for (uint32_t k = 0; k < 3; ++k) {
    const Vec3 size = dice.size({0.7, 0.5, 0.5}, {1, 0.8, 0.8});
    const Transform place = placed(at[k].x, at[k].y, dice.turn_deg());
    const double x = dice.between(0.15, 0.4), y = dice.between(-0.2, 0.2),
                 turn = dice.between(-30, 30);
    const uint32_t object = kFirstThing + k;
    table(out.before, size, place, object);
    table(out.after, size, k < 2 ? place * placed(x, y, turn) : place, object);
    if (k < 2) out.change(object, Happened::kMoved, x);
  }
  return out;
}

inline EpochScenes pit_and_bulge(uint64_t seed) {
  SceneDice dice(seed, 23);
  EpochScenes out;
  set_up(out, dice);
  const FloorPatch flat{dice.between(-0.8, 0.8),
                        dice.between(-1.5, 0.5),
                        dice.between(0.6, 1.2),
                        dice.between(0.6, 1),
                        0,
                        kFirstThing};
  FloorPatch sunk = flat;
  sunk.height_m = -dice.between(0.06, 0.2);
  const double bulge = dice.between(0.05, 0.12), left = dice.between(-2, -0.5);
  const auto bulging = [&](TriangleScene& s, double by) {
    wall(s, kWallAt_m, kYardHalf_m, kWallHeight_m, kWall, {{left, left + 2, 0.3, 2, 1e-9, 9}});
    s.surface(16, 16, kFirstThing + 1, [&](double u, double t) {
      const double a = std::sin(std::numbers::pi * u), b = std::sin(std::numbers::pi * t);
      return Vec3{left + 2 * u, kWallAt_m - 0.001 - by * a * a * b * b, 0.3 + 1.7 * t};
    });
  };
  for (const bool is_after : {false, true}) {
    TriangleScene& s = is_after ? out.after : out.before;
    floor_with(s, kYardHalf_m, is_after ? sunk : flat, kFloor);
    bulging(s, is_after ? bulge : 0);
  }
  clutter(out, dice, seed);
  out.change(kFirstThing, Happened::kGaveWay, -sunk.height_m);
  out.change(kFirstThing + 1, Happened::kGaveWay, bulge);
  return out;
}

/// Earth taken from the side of a heap, and a board that sags between two trestles.
inline EpochScenes heap_and_board(uint64_t seed) {
  SceneDice dice(seed, 24);
  EpochScenes out;
  yard(out, dice, seed);
  const double radius = dice.between(0.8, 1.1), height = dice.between(0.5, 0.8);
  const double taken = dice.between(0.1, 0.25), angle = dice.between(-2.4, -0.7);
  const double sag = dice.between(0.1, 0.2);
  const auto heap = [&](TriangleScene& s, double bite) {
    s.surface(48, 24, kFirstThing, [&](double u, double t) {
      const double a = 2 * std::numbers::pi * u, r = radius * t;
      const double x = r * std::cos(a) - 0.6 * radius * std::cos(angle),
                   y = r * std::sin(a) - 0.6 * radius * std::sin(angle);
      const double full = height * (1 - t) * (1 + t);
      const double cut = bite * std::exp(-(x * x + y * y) / (2 * 0.25 * 0.25));
      return Vec3{r * std::cos(a) - 1, r * std::sin(a), std::max(full - cut, 0.0)};
    });
  };
  const auto board = [&](TriangleScene& s, double bend) {
    s.surface(24, 1, kFirstThing + 1, [&](double u, double t) {
      return Vec3{0.6 + 1.8 * u, 0.3 * t, 0.9 - bend * 4 * u * (1 - u)};
    });
    for (const double x : {0.65, 2.35}) s.box({0.08, 0.3, 0.85}, placed(x, 0.15, 0), kClutter + 3);
  };
  heap(out.before, 0);
  heap(out.after, taken);
  board(out.before, 0);
  board(out.after, sag);
  out.change(kFirstThing, Happened::kGaveWay, taken);
  out.change(kFirstThing + 1, Happened::kGaveWay, sag);
  return out;
}

/// One of several equal barrels in a row goes, another is set out of the row.
inline EpochScenes equal_barrels(uint64_t seed) {
  SceneDice dice(seed, 25);
  EpochScenes out;
  yard(out, dice, seed);
  const double radius = dice.between(0.25, 0.3), height = dice.between(0.6, 0.9);
  const double y = dice.between(-0.5, 0.8);
  const auto gone = static_cast<uint32_t>(dice.below(2)),
             moved = 2 + static_cast<uint32_t>(dice.below(3));
  const double out_of_row = dice.between(0.15, 0.5);
  for (uint32_t k = 0; k < 5; ++k) {
    const Vec3 at{0.9 * k - 1.8, y, 0}, to{at.x, y - (k == moved ? out_of_row : 0), 0};
    const uint32_t object = kFirstThing + k;
    tube(out.before, at, radius, height, object);
    if (k != gone) tube(out.after, to, radius, height, object);
  }
  out.change(kFirstThing + gone, Happened::kWent, height);
  out.change(kFirstThing + moved, Happened::kMoved, out_of_row);
  return out;
}

inline void furnished(EpochScenes& out, SceneDice& dice, uint64_t seed) {
  const double half = 3;
  const auto stand = [&](std::vector<ScanStation>& to) {
    for (int k = 0; k < 2; ++k) {
      ScanStation& s = to.emplace_back();
      s.name = "station " + std::to_string(k + 1);
      const double x = dice.between(-0.5, 0.5), y = dice.between(-0.5, 0.5);
      s.pose.m[3] = k == 0 ? -1.8 + x : 1.8 + x;
      s.pose.m[7] = k == 0 ? -1.8 + y : 1.8 + y;
      s.pose.m[11] = 1.6;
    }
  };
  stand(out.from_before);
  stand(out.from_after);
  out.setting.step_rad = dice.between(0.014, 0.018);
  out.setting.noise_m = dice.between(0.001, 0.004);
  std::vector<Transform> at;
  for (int k = 0; k < 4; ++k)
    at.push_back(placed(k % 2 == 0 ? 1.7 * (k - 1) : 0.9 * (k - 2), k % 2 == 0 ? -0.2 : 0.3,
                        dice.turn_deg()));
  const Vec3 of = dice.size({0.8, 0.6, 0.6}, {1.1, 0.8, 0.8});
  out.both([&](TriangleScene& s) {
    s.box({2 * half, 2 * half, 2.6}, Transform{}, kFloor);
    table(s, of, at[0], kClutter);
    s.box({0.5, 0.5, 0.45}, at[1], kClutter + 1);
    s.box({0.4, 1.2, 2}, placed(2.8, -1, 0), kClutter + 2);
    tube(s, {-2.4, 2.3, 0}, 0.15, 1.2, kClutter + 3);
    bush(s, {2.3, -2.4, 0}, 0.3, seed, kClutter + 4);
  });
}

inline EpochScenes unchanged_room(uint64_t seed) {
  SceneDice dice(seed, 26);
  EpochScenes out;
  furnished(out, dice, seed);
  return out;
}

/// Of a row one behind the other, the middle one goes or comes half in the shadow of the first.
inline EpochScenes shadowed_neighbours(uint64_t seed) {
  SceneDice dice(seed, 27);
  EpochScenes out;
  yard(out, dice, seed);
  for (uint32_t row = 0; row < 2; ++row) {
    const double x = row == 0 ? -1.2 : 1.2, turn = dice.between(-10, 10);
    for (uint32_t k = 0; k < 3; ++k) {
      const Vec3 size = dice.size({0.7, 0.3, 0.5 + 0.2 * k}, {1.1, 0.5, 0.7 + 0.3 * k});
      const Transform place = placed(x + dice.between(-0.2, 0.2), 1.1 * k - 1.4, turn);
      const uint32_t object = kFirstThing + 3 * row + k;
      const bool changes = k == 1;
      if (!changes || row == 0) out.before.box(size, place, object);
      if (!changes || row == 1) out.after.box(size, place, object);
      if (changes) out.change(object, row == 0 ? Happened::kWent : Happened::kCame, size.z);
    }
  }
  return out;
}

/// A door is opened, and a piece of the wall leans over.
inline EpochScenes door_and_leaning_wall(uint64_t seed) {
  SceneDice dice(seed, 28);
  EpochScenes out;
  set_up(out, dice);
  const double angle = dice.between(25, 70), hinge = dice.between(-2, -1);
  const double lean = dice.between(0.03, 0.06), x = dice.between(0.6, 1.2);
  const auto scene = [&](TriangleScene& s, double turn, double over) {
    s.ground(kYardHalf_m, kFloor);
    s.box({0.9, 0.05, 2}, placed(hinge, 1.8, -turn) * placed(0.45, 0, 0), kFirstThing);
    const auto sheet = [&](double x0, double x1, double top, uint32_t object) {
      s.quad({x0, kWallAt_m, 0}, {x1, kWallAt_m, 0}, {x1, kWallAt_m - top, kWallHeight_m},
             {x0, kWallAt_m - top, kWallHeight_m}, object);
    };
    sheet(-kYardHalf_m, x, 0, kWall);
    sheet(x, x + 1.8, over * kWallHeight_m, kFirstThing + 1);
    sheet(x + 1.8, kYardHalf_m, 0, kWall);
  };
  scene(out.before, 5, 0);
  scene(out.after, 5 + angle, lean);
  clutter(out, dice, seed);
  out.change(kFirstThing, Happened::kMoved, 0.9 * angle * std::numbers::pi / 180);
  out.change(kFirstThing + 1, Happened::kGaveWay, kWallHeight_m * lean);
  return out;
}

inline constexpr std::array<SceneKind, 8> kReportedChanges{{
    {"poles and barrels", poles_and_barrels},
    {"tables moved", tables_moved},
    {"pit and bulge", pit_and_bulge},
    {"heap and board", heap_and_board},
    {"equal barrels", equal_barrels},
    {"unchanged room", unchanged_room},
    {"shadowed neighbours", shadowed_neighbours},
    {"door and leaning wall", door_and_leaning_wall},
}};

}  // namespace jalon::test
