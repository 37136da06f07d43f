// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Kinds of scenes of which a rigid motion explains much and is not what happened, each with one that did move. They are
// developed on, as those of change_kinds_developed.h.

#include "change_kinds.h"

namespace jalon::test {

/// Two boxes side by side, the second one lower: no turn lays it onto itself.
inline void step(TriangleScene& scene, const Vec3& size, const Transform& place, uint32_t object) {
  const Vec3 half{0.5 * size.x, size.y, size.z}, low{half.x, size.y, 0.5 * size.z};
  scene.box(half, place * placed(-half.x / 2, 0, 0), object);
  scene.box(low, place * placed(half.x / 2, 0, 0), object);
}

/// A slab on a foot in its middle.
inline void mushroom(TriangleScene& scene, const Vec3& size, const Transform& place,
                     uint32_t object) {
  constexpr double kSlab_m = 0.08, kFoot = 0.4;
  scene.box({kFoot * size.x, kFoot * size.y, size.z - kSlab_m}, place, object);
  scene.box({size.x, size.y, kSlab_m}, place * placed(0, 0, 0, size.z - kSlab_m), object);
}

/// Where one thing stood, within its size, another one stands that is about as large and of another shape.
inline EpochScenes unlike_neighbours(uint64_t seed) {
  SceneDice dice(seed, 12);
  EpochScenes out;
  yard(out, dice, seed);
  for (uint32_t k = 0; k < 3; ++k) {
    const Vec3 size = dice.size({0.5, 0.4, 0.4}, {0.8, 0.6, 0.9});
    const double x = 1.7 * k - 2, y = dice.between(-1.4, -0.9);
    const double way = size.y + dice.between(0.15, 0.6), aside = dice.between(-0.15, 0.15);
    const Transform was = placed(x, y, dice.between(-20, 20)),
                    is = placed(x + aside, y + way, dice.between(-20, 20));
    const uint32_t object = kFirstThing + 2 * k;
    if (k == 0) {
      out.before.box(size, was, object);
      step(out.after, size, is, object + 1);
    } else if (k == 1) {
      mushroom(out.before, size, was, object);
      out.after.box(size, is, object + 1);
    } else {
      step(out.before, size, was, object);
      step(out.after, size, is, object);
      out.change(object, Happened::kMoved, way);
      continue;
    }
    out.change(object, Happened::kWent, size.z);
    out.change(object + 1, Happened::kCame, size.z);
  }
  return out;
}

/// Another thing of the same kind, and not of the same size, stands beside where one stood.
inline EpochScenes other_sizes(uint64_t seed) {
  SceneDice dice(seed, 13);
  EpochScenes out;
  yard(out, dice, seed);
  for (uint32_t k = 0; k < 4; ++k) {
    const Vec3 small = dice.size({0.4, 0.35, 0.3}, {0.7, 0.5, 0.6});
    const double by = k == 3 ? 1 : dice.between(1.2, 1.6);
    const Vec3 large{by * small.x, (k == 1 ? 1 : by) * small.y, (k == 2 ? 1 : by) * small.z};
    const double x = k % 2 == 0 ? -1.5 : 1, y = k < 2 ? -1.5 : 0.7;
    const double way = 0.5 * (small.x + large.x) + dice.between(0.1, 0.5);
    const double turn = dice.turn_deg();
    const Transform was = placed(x, y, turn),
                    is = was * placed(way, dice.between(-0.1, 0.1), dice.between(-15, 15));
    const bool grows = dice.below(2) != 0;
    const uint32_t object = kFirstThing + 2 * k;
    const auto add = [&](TriangleScene& s, const Vec3& size, const Transform& place, uint32_t of) {
      k == 0 ? step(s, size, place, of) : s.box(size, place, of);
    };
    add(out.before, grows ? small : large, was, object);
    add(out.after, grows ? large : small, is, k == 3 ? object : object + 1);
    if (k == 3) {
      out.change(object, Happened::kMoved, way);
      continue;
    }
    out.change(object, Happened::kWent, grows ? small.z : large.z);
    out.change(object + 1, Happened::kCame, grows ? large.z : small.z);
  }
  return out;
}

/// Of walls as thick as they stand free, one leans over, one has a belly and one was slid; the upper half of the yard's
/// wall leans in a part of it.
inline EpochScenes walls_give_way(uint64_t seed) {
  SceneDice dice(seed, 14);
  EpochScenes out;
  set_up(out, dice);
  const double thick = dice.between(0.15, 0.3);
  const double lean = dice.sign() * dice.between(0.03, 0.1), belly = dice.between(0.06, 0.15);
  const double slid = dice.between(0.15, 0.5), over = dice.between(0.04, 0.1);
  const double left = dice.between(-2.5, 0);
  const double turns[] = {dice.between(-15, 15), dice.between(-15, 15), dice.between(-15, 15)};
  const Vec3 size = dice.size({1.2, thick, 0.9}, {1.7, thick, 1.4});
  const auto standing = [&](TriangleScene& s, const Transform& place, double leans, double bulges,
                            uint32_t object) {
    const auto face = [&](double side) {
      s.surface(14, 14, object, [&](double u, double t) {
        const double a = std::sin(std::numbers::pi * u), b = std::sin(std::numbers::pi * t);
        const double bulge = side < 0 ? bulges * a * a * b * b : 0;
        return place.point(
            {(u - 0.5) * size.x, side * thick / 2 - bulge - leans * size.z * t, size.z * t});
      });
    };
    face(-1);
    face(1);
    const double top = leans * size.z;
    for (const double x : {-0.5 * size.x, 0.5 * size.x})
      s.quad(place.point({x, -thick / 2, 0}), place.point({x, thick / 2, 0}),
             place.point({x, thick / 2 - top, size.z}), place.point({x, -thick / 2 - top, size.z}),
             object);
    s.quad(place.point({-size.x / 2, -thick / 2 - top, size.z}),
           place.point({size.x / 2, -thick / 2 - top, size.z}),
           place.point({size.x / 2, thick / 2 - top, size.z}),
           place.point({-size.x / 2, thick / 2 - top, size.z}), object);
  };
  for (const bool is_after : {false, true}) {
    TriangleScene& s = is_after ? out.after : out.before;
    s.ground(kYardHalf_m, kFloor);
    standing(s, placed(-1.9, 0, turns[0]), is_after ? lean : 0, 0, kFirstThing);
    standing(s, placed(0.2, -0.9, turns[1]), 0, is_after ? belly : 0, kFirstThing + 1);
    standing(s, placed(1.9, 0.6, turns[2]) * placed(is_after ? slid : 0, 0, 0), 0, 0,
             kFirstThing + 2);
    const double half = 0.5 * kWallHeight_m, out_m = is_after ? over * half : 0;
    wall(s, kWallAt_m, kYardHalf_m, half, kWall);
    const auto upper = [&](double x0, double x1, double by, uint32_t object) {
      s.quad({x0, kWallAt_m, half}, {x1, kWallAt_m, half}, {x1, kWallAt_m - by, kWallHeight_m},
             {x0, kWallAt_m - by, kWallHeight_m}, object);
    };
    upper(-kYardHalf_m, left, 0, kWall);
    upper(left, left + 2, out_m, kFirstThing + 3);
    upper(left + 2, kYardHalf_m, 0, kWall);
  }
  clutter(out, dice, seed);
  out.change(kFirstThing, Happened::kGaveWay, std::abs(lean) * size.z);
  out.change(kFirstThing + 1, Happened::kGaveWay, belly);
  out.change(kFirstThing + 2, Happened::kMoved, slid);
  out.change(kFirstThing + 3, Happened::kGaveWay, over * kWallHeight_m / 2);
  return out;
}

/// One end of a thing changes: bricks are set to a pile, others are taken from one, a berm is filled up at one side,
/// and a crate is pushed by as much.
inline EpochScenes growth(uint64_t seed) {
  SceneDice dice(seed, 15);
  EpochScenes out;
  yard(out, dice, seed);
  const std::vector<Vec3> at = dice.places();
  for (uint32_t k = 0; k < 3; ++k) {
    const Vec3 size = dice.size({0.6, 0.4, 0.35}, {0.9, 0.6, 0.7});
    const double end = dice.between(0.2, 0.5);
    const Vec3 added{end, size.y, size.z};
    const Transform place = placed(at[k].x, at[k].y, dice.turn_deg()),
                    beside = place * placed((size.x + end) / 2, 0, 0);
    const uint32_t object = kFirstThing + 2 * k;
    out.before.box(size, place, object);
    out.after.box(size, k == 2 ? place * placed(end, 0, 0) : place, object);
    if (k == 0) out.after.box(added, beside, object + 1);
    if (k == 1) out.before.box(added, beside, object + 1);
    if (k == 2) out.change(object, Happened::kMoved, end);
    else out.change(object + 1, k == 0 ? Happened::kCame : Happened::kWent, size.z);
  }
  constexpr uint32_t kBerm = kFirstThing + 6;
  const double high = dice.between(0.4, 0.7), filled = dice.between(0.1, 0.3),
               wide = dice.between(0.5, 0.7), turn = dice.turn_deg();
  const auto berm = [&](TriangleScene& s, double fill) {
    s.surface(24, 24, kBerm, [&](double u, double t) {
      const double a = 2 * u - 1, b = 2 * t - 1, rise = (1 - a * a) * (1 - b * b);
      const double slope = a > 0 ? fill * 16 * a * a * (1 - a) * (1 - a) * (1 - b * b) : 0;
      const Vec3 p = placed(at[3].x, at[3].y, turn).point({wide * a, 0.6 * b, 0});
      return Vec3{p.x, p.y, high * rise + slope};
    });
  };
  berm(out.before, 0);
  berm(out.after, filled);
  out.change(kBerm, Happened::kGaveWay, filled);
  return out;
}

/// Cabinets that fell on their sides, and one that stands; a sheet of canvas between posts sways.
inline EpochScenes toppled(uint64_t seed) {
  SceneDice dice(seed, 16);
  EpochScenes out;
  yard(out, dice, seed);
  const std::vector<Vec3> at = dice.places();
  for (uint32_t k = 0; k < 3; ++k) {
    const Vec3 size = dice.size({0.35, 0.3, 0.7}, {0.5, 0.45, 1.1});
    const Transform place = placed(at[k].x, at[k].y, dice.turn_deg());
    const uint32_t object = kFirstThing + k;
    out.before.box(size, place, object);
    // About the edge of its foot at x = size.x / 2.
    Transform fall = rotation_by({0, std::numbers::pi / 2, 0});
    fall.m[3] = size.x / 2;
    fall.m[11] = size.x / 2;
    out.after.box(size, k < 2 ? place * fall : place, object);
    if (k < 2) out.change(object, Happened::kMoved, size.z);
  }
  constexpr uint32_t kCanvas = kFirstThing + 3;
  const double sway = dice.sign() * dice.between(0.08, 0.2), wide = dice.between(1.2, 1.8);
  const Transform place = placed(at[4].x, at[4].y, dice.between(-30, 30));
  for (const bool is_after : {false, true}) {
    TriangleScene& s = is_after ? out.after : out.before;
    for (const double x : {-0.5, 0.5})
      s.box({0.06, 0.06, 1.4}, place * placed(x * wide, 0, 0), kClutter + 3);
    s.surface(16, 10, kCanvas, [&](double u, double t) {
      const double a = std::sin(std::numbers::pi * u);
      return place.point({wide * (u - 0.5), is_after ? -sway * a * a : 0, 0.3 + t});
    });
  }
  out.change(kCanvas, Happened::kGaveWay, std::abs(sway));
  return out;
}

}  // namespace jalon::test
