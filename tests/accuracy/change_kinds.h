// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Two epochs of a place with truth: what a kind of scene is made of.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "change_scenes.h"
#include "compare/changes/diagnosis.h"

namespace jalon::test {

/// What became of a thing: overlap is no matter of the truth here.
enum class Happened : uint8_t { kCame, kWent, kMoved, kGaveWay };

inline Happened happened(ChangeClass c) {
  switch (c) {
    case ChangeClass::kAppearance:
      return Happened::kCame;
    case ChangeClass::kDisappearance:
      return Happened::kWent;
    case ChangeClass::kDisplacement:
    case ChangeClass::kDisplacementOverlap:
      return Happened::kMoved;
    default:
      return Happened::kGaveWay;
  }
}

struct TrueChange {
  uint32_t object;
  Happened what;
  double size_m;  ///< the most that a point of it changed by
};

/// Both epochs as triangles, from where they are scanned, and what changed.
struct EpochScenes {
  TriangleScene before, after;
  std::vector<ScanStation> from_before, from_after;
  ScanSetting setting;
  std::vector<TrueChange> changes;

  template <class F>
  void both(F&& add) {
    add(before);
    add(after);
  }
  void change(uint32_t object, Happened what, double size_m) {
    changes.push_back({object, what, size_m});
  }
};

/// What a kind draws from: nothing is drawn in the calls' arguments, whose order compilers choose.
class SceneDice {
 public:
  SceneDice(uint64_t seed, uint64_t kind) : random_(seed, 100 + kind) {}
  double between(double low, double high) { return low + (high - low) * random_.uniform(); }
  uint64_t below(uint64_t n) { return random_.below(n); }
  double sign() { return random_.below(2) != 0 ? 1 : -1; }
  double turn_deg() { return 360 * random_.uniform(); }
  Vec3 size(const Vec3& low, const Vec3& high) {
    Vec3 out;
    for (int k = 0; k < 3; ++k) out[k] = between(low[k], high[k]);
    return out;
  }
  /// Nine places 1.5 m apart about the origin, in random order, each off its middle by up to 0.1 m.
  std::vector<Vec3> places() {
    std::vector<Vec3> out;
    for (int k = 0; k < 9; ++k) out.push_back({1.5 * (k % 3 - 1), 1.5 * (k / 3 - 1), 0});
    for (size_t k = 8; k > 0; --k) std::swap(out[k], out[random_.below(k + 1)]);
    for (Vec3& p : out)
      for (int c = 0; c < 2; ++c) p[c] += between(-0.1, 0.1);
    return out;
  }

 private:
  RandomStream random_;
};

/// An upright tube with a lid.
inline void tube(TriangleScene& scene, const Vec3& foot, double radius_m, double height_m,
                 uint32_t object) {
  constexpr int kFacets = 24;
  const auto at = [&](double s, double r, double z) {
    const double a = 2 * std::numbers::pi * s;
    return Vec3{foot.x + r * std::cos(a), foot.y + r * std::sin(a), foot.z + z};
  };
  scene.surface(kFacets, 1, object,
                [&](double s, double t) { return at(s, radius_m, height_m * t); });
  for (int k = 0; k < kFacets; ++k)
    scene.triangle(at(0, 0, height_m), at(1.0 * k / kFacets, radius_m, height_m),
                   at((k + 1.0) / kFacets, radius_m, height_m), object);
}

/// Leaves of 60 to 120 mm in a ball above the foot.
inline void bush(TriangleScene& scene, const Vec3& foot, double radius_m, uint64_t seed,
                 uint32_t object) {
  RandomStream random(seed, 77);
  constexpr int kLeaves = 150;
  for (int k = 0; k < kLeaves; ++k) {
    Vec3 p, u, v;
    for (int c = 0; c < 3; ++c) p[c] = random.normal();
    for (int c = 0; c < 3; ++c) u[c] = random.normal();
    for (int c = 0; c < 3; ++c) v[c] = random.normal();
    p = foot + Vec3{0, 0, radius_m} + normalized(p) * (radius_m * std::cbrt(random.uniform()));
    const double size = 0.06 + 0.06 * random.uniform();
    scene.triangle(p, p + normalized(u) * size, p + normalized(v) * size, object);
  }
}

/// A top on four legs.
inline void table(TriangleScene& scene, const Vec3& size, const Transform& place, uint32_t object) {
  constexpr double kTop_m = 0.05, kLeg_m = 0.06;
  scene.box({size.x, size.y, kTop_m}, place * placed(0, 0, 0, size.z - kTop_m), object);
  for (const double x : {-0.45, 0.45})
    for (const double y : {-0.45, 0.45})
      scene.box({kLeg_m, kLeg_m, size.z - kTop_m}, place * placed(x * size.x, y * size.y, 0),
                object);
}

/// A rectangle of a wall, off by how much towards the stations; 0: flush.
struct WallPanel {
  double x0, x1, z0, z1;
  double off_m;
  uint32_t object;
};

/// The wall y = at, which faces -y, around its panels, which follow one another in x.
inline void wall(TriangleScene& scene, double at, double half_m, double height_m, uint32_t object,
                 const std::vector<WallPanel>& panels = {}) {
  const auto sheet = [&](double x0, double x1, double z0, double z1, double y, uint32_t of) {
    if (x1 > x0 && z1 > z0) scene.quad({x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}, of);
  };
  double from = -half_m;
  for (const WallPanel& p : panels) {
    sheet(from, p.x0, 0, height_m, at, object);
    sheet(p.x0, p.x1, 0, p.z0, at, object);
    sheet(p.x0, p.x1, p.z1, height_m, at, object);
    sheet(p.x0, p.x1, p.z0, p.z1, at - p.off_m, p.object);
    from = p.x1;
    if (p.off_m == 0) continue;
    for (const double x : {p.x0, p.x1})
      scene.quad({x, at, p.z0}, {x, at - p.off_m, p.z0}, {x, at - p.off_m, p.z1}, {x, at, p.z1},
                 p.object);
  }
  sheet(from, half_m, 0, height_m, at, object);
}

/// A floor with a rectangle of 2 a by 2 b about (x, y), that rises by up to height_m in its middle and joins its rim.
struct FloorPatch {
  double x, y, a, b, height_m;
  uint32_t object;
};
inline void floor_with(TriangleScene& scene, double half, const FloorPatch& p, uint32_t object) {
  const auto sheet = [&](double x0, double x1, double y0, double y1) {
    scene.quad({x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}, object);
  };
  sheet(-half, p.x - p.a, -half, half);
  sheet(p.x + p.a, half, -half, half);
  sheet(p.x - p.a, p.x + p.a, -half, p.y - p.b);
  sheet(p.x - p.a, p.x + p.a, p.y + p.b, half);
  scene.surface(16, 16, p.object, [&](double s, double t) {
    const double u = std::sin(std::numbers::pi * s), v = std::sin(std::numbers::pi * t);
    return Vec3{p.x + p.a * (2 * s - 1), p.y + p.b * (2 * t - 1), p.height_m * u * u * v * v};
  });
}

/// Two or three tripods around, in one run of three at the same places in both epochs; noise and steps of some scanner.
inline void set_up(EpochScenes& out, SceneDice& dice, double distance_m = 6) {
  const int count = 2 + static_cast<int>(dice.below(2));
  const double first = dice.between(-70, -20), height = dice.between(1.5, 2.2);
  const double other = dice.below(3) == 0 ? 0 : dice.between(10, 40);
  // Before the wall, on the arc of its front.
  const auto arc = [&](double turn) {
    std::vector<ScanStation> stations;
    for (int k = 0; k < count; ++k) {
      const double a = (first - turn - 120.0 * k / count) * std::numbers::pi / 180;
      ScanStation& s = stations.emplace_back();
      s.name = "station " + std::to_string(k + 1);
      s.pose.m[3] = distance_m * std::cos(a);
      s.pose.m[7] = distance_m * std::sin(a);
      s.pose.m[11] = height;
    }
    return stations;
  };
  out.from_before = arc(0);
  out.from_after = arc(other);
  out.setting.step_rad = dice.between(0.005, 0.007);
  out.setting.noise_m = dice.between(0.001, 0.004);
}

constexpr uint32_t kFloor = 1, kWall = 2, kClutter = 3, kFirstThing = 10;
constexpr double kYardHalf_m = 4, kWallAt_m = 3.4, kWallHeight_m = 2.4;

/// Things at the rims that stay as they are.
inline void clutter(EpochScenes& out, SceneDice& dice, uint64_t seed) {
  const double x = dice.between(-3.3, -2.9), y = dice.between(-1.5, 1.5);
  const double turn = dice.turn_deg();
  const Vec3 size = dice.size({0.3, 0.3, 0.4}, {0.8, 0.6, 1.2});
  const double bush_y = dice.between(1.5, 2.6), pole_y = dice.between(-2, 1);
  out.both([&](TriangleScene& s) {
    s.box(size, placed(x, y, turn), kClutter);
    bush(s, {3.2, bush_y, 0}, 0.35, seed, kClutter + 1);
    tube(s, {3.3, pole_y, 0}, 0.06, 2.2, kClutter + 2);
  });
}

inline void yard(EpochScenes& out, SceneDice& dice, uint64_t seed) {
  set_up(out, dice);
  out.both([](TriangleScene& s) {
    s.ground(kYardHalf_m, kFloor);
    wall(s, kWallAt_m, kYardHalf_m, kWallHeight_m, kWall);
  });
  clutter(out, dice, seed);
}

struct SceneKind {
  const char* name;
  EpochScenes (*make)(uint64_t seed);
};

}  // namespace jalon::test
