// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/builder/objects.h"

#include <cmath>
#include <numbers>

namespace jalon {

namespace {

constexpr int kObjectsFacets = 32;
constexpr double kLeaf_m = 0.12;  // leaves are triangles of random corners in a ball of this radius
/// Mean area of such a triangle over the squared radius: 0.367 by simulation; its mean shadow is half of it (Cauchy).
constexpr double kLeafArea = 0.367;

}  // namespace

void add_car(SceneBuilder& out, uint32_t parent, const Vec3& corner, double length_m) {
  out.box(out.part("car", "car", parent), corner, {length_m, 1.8, 1.5}, true);
}

void add_stair(SceneBuilder& out, uint32_t parent, const Vec3& corner) {
  constexpr int kTreads = 16, kPosts = 5;
  constexpr double kGoing = 0.28, kRise = 0.18, kWidth = 1.2, kTread = 0.04, kPost = 0.06,
                   kRail = 0.9;
  const uint32_t stair = out.part("stair", "stair", parent);
  for (int i = 0; i < kTreads; ++i)
    out.box(stair, corner + Vec3{i * kGoing, 0, (i + 1) * kRise - kTread},
            {kGoing - 0.02, kWidth, kTread}, true);
  for (int i = 0; i < kPosts; ++i) {
    const double along = (kTreads - 1) * kGoing * i / (kPosts - 1),
                 top = (kTreads - 1.0) * kRise * i / (kPosts - 1);
    for (const double across : {-kPost, kWidth})
      out.box(stair, corner + Vec3{along, across, 0}, {kPost, kPost, top + kRise + kRail}, false);
  }
}

void add_crown(SceneBuilder& out, uint32_t parent, const Vec3& middle, double radius_m,
               double opacity, const RandomStream& random) {
  out.part("tree", "tree", parent);
  // Light through the middle, Beer & Lambert: 1 - opacity = exp(-leaves x shadow / volume x diameter).
  const double shadow = kLeafArea * kLeaf_m * kLeaf_m / 2, diameter = 2 * radius_m;
  const double volume = std::numbers::pi * diameter * diameter * diameter / 6;
  const auto leaves =
      static_cast<int>(std::lround(-std::log(1 - opacity) * volume / (shadow * diameter)));
  out.crown(middle, radius_m, leaves, kLeaf_m, random);
}

void add_tree(SceneBuilder& out, uint32_t parent, const Vec3& crown_middle, double crown_radius_m,
              double opacity, const RandomStream& random) {
  add_crown(out, parent, crown_middle, crown_radius_m, opacity, random);
  out.cylinder({crown_middle.x, crown_middle.y, 0}, 0.12, crown_middle.z, kObjectsFacets);
}

void add_pedestrian(SceneBuilder& out, uint32_t parent, const Vec3& foot) {
  out.part("pedestrian", "pedestrian", parent);
  out.cylinder(foot, 0.22, 1.5, kObjectsFacets);
  out.sphere(foot + Vec3{0, 0, 1.62}, 0.13, kObjectsFacets);
}

}  // namespace jalon
