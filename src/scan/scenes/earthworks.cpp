// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Four days of an earthworks site: the synthetic equivalent of Girardeau-Montaut 2006, 2.3.3 and figures 2.12-2.14.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scan/scenes/scenes.h"

namespace jalon {

namespace {

constexpr double kDegree_rad = std::numbers::pi / 180;
constexpr double kLength_m = 60, kEarthworksWidth_m = 40;  // along X and Y
constexpr double kStep_m = 0.125;  // of the ground's triangles; every border of a change lies on it
constexpr double kEarthworksWallHeight_m = 8, kFooting_m = 1.5;

constexpr Vec2 kHeap{44, 24};
constexpr double kHeapRadius_m = 1.5, kHeapHeight_m = 1;
constexpr Rect kPit{34, 42, 12, 17};
constexpr double kPitDepth_m = 1.2, kPitBatter_m = 0.5;  // the sides lean this far outward

/// What stands where on a day.
struct Day {
  bool heap, pit, excavator, free_wall;
  Vec2 excavator_at;
  double excavator_turn_rad;
};
constexpr Day kDays[] = {{false, false, false, true, {}, 0},
                         {true, false, false, true, {}, 0},
                         {true, true, true, true, {18, 20}, 0},
                         // 6 m away: without overlap of the old and the new place.
                         {true, true, true, false, {14, 24.4721359549995794}, 40 * kDegree_rad}};

double relief_m(double x, double y) {
  return 0.3 * std::sin(2 * std::numbers::pi * x / 27 + 0.7) +
         0.2 * std::cos(2 * std::numbers::pi * y / 19);
}

/// What was heaped up (positive) or dug out: a cone, and a pit with even sides.
double earth_moved_m(const Day& day, double x, double y) {
  double height = 0;
  if (day.heap)
    height +=
        kHeapHeight_m * std::max(0.0, 1 - std::hypot(x - kHeap.u, y - kHeap.v) / kHeapRadius_m);
  if (day.pit) {
    const double inside =
        std::min(std::min(x - kPit.u0, kPit.u1 - x), std::min(y - kPit.v0, kPit.v1 - y));
    height -= kPitDepth_m * std::clamp(inside / kPitBatter_m, 0.0, 1.0);
  }
  return height;
}

void add_ground(SceneBuilder& out, const Day& day) {
  const uint32_t ground = out.new_id(), heap = out.new_id(), pit = out.new_id();
  const auto columns = static_cast<uint32_t>(kLength_m / kStep_m),
             rows = static_cast<uint32_t>(kEarthworksWidth_m / kStep_m);
  out.relief(
      columns, rows,
      [&](uint32_t i, uint32_t j) {
        const double x = i * kStep_m, y = j * kStep_m;
        return Vec3{x, y, relief_m(x, y) + earth_moved_m(day, x, y)};
      },
      [&](uint32_t i, uint32_t j) {
        const double moved = earth_moved_m(day, (i + 0.5) * kStep_m, (j + 0.5) * kStep_m);
        return moved > 0 ? heap : moved < 0 ? pit : ground;
      });
}

/// A box of length x width x height whose foot has its middle here, turned about the vertical, then leant up.
void add_block(SceneBuilder& out, uint32_t part, const Vec3& foot, const Vec3& along,
               const Vec3& across, const Vec3& size) {
  const Vec3 up = cross(along, across);
  const Vec3 corner = foot - along * (size.x / 2) - across * (size.y / 2);
  const Vec3 far = corner + along * size.x + across * size.y + up * size.z;
  out.face(part, {corner, along, up}, {0, size.x, 0, size.z});
  out.face(part, {corner, up, across}, {0, size.z, 0, size.y});
  out.face(part, {corner, across, along}, {0, size.y, 0, size.x});
  out.face(part, {far, -up, -along}, {0, size.z, 0, size.x});
  out.face(part, {far, -across, -up}, {0, size.y, 0, size.z});
  out.face(part, {far, -along, -across}, {0, size.x, 0, size.y});
}

void add_excavator(SceneBuilder& out, uint32_t site, const Day& day) {
  constexpr Vec3 kBody{3, 2.5, 3}, kArm{5, 0.4, 0.4};
  constexpr double kArmRise_rad = 30 * kDegree_rad, kArmHeight_m = 1.5;
  const double c = std::cos(day.excavator_turn_rad), s = std::sin(day.excavator_turn_rad);
  const Vec3 along{c, s, 0}, across{-s, c, 0}, up{0, 0, 1};
  const Vec3 foot{day.excavator_at.u, day.excavator_at.v,
                  relief_m(day.excavator_at.u, day.excavator_at.v)};
  // Tracks sink in: the body begins below the highest ground under it.
  const Vec3 base = foot - up * 0.3;
  add_block(out, out.part("body", "excavator", site), base, along, across, kBody + Vec3{0, 0, 0.3});
  const Vec3 arm = along * std::cos(kArmRise_rad) + up * std::sin(kArmRise_rad);
  const Vec3 root = foot + along * (kBody.x / 2) + up * kArmHeight_m;
  add_block(out, out.part("arm", "excavator", site), root + arm * (kArm.x / 2), arm, across, kArm);
}

}  // namespace

void build_earthworks(const SceneSettings& settings, SceneBuilder& out) {
  const Day& day = kDays[settings.day - 1];
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const uint32_t site = out.part("site", "site");
  add_ground(out, day);
  const uint32_t walls = out.part("walls", "wall", site);
  out.face(walls, {y * kEarthworksWidth_m - z * kFooting_m, x, z},
           {0, kLength_m, 0, kEarthworksWallHeight_m + kFooting_m});
  out.face(walls, {z * -kFooting_m, z, y},
           {0, kEarthworksWallHeight_m + kFooting_m, 0, kEarthworksWidth_m});
  const Vec3 size{6, 0.3, 3}, corner{22, 24, relief_m(25, 24)};
  if (day.free_wall)
    out.box(out.part("free wall", "free_wall", site), corner - z * kFooting_m,
            size + z * kFooting_m, false);
  else
    for (int face = 0; face < 5; ++face) out.new_id();  // the other ids stay the same on all days
  if (day.excavator) add_excavator(out, site, day);
}

}  // namespace jalon
