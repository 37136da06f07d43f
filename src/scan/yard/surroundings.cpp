// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/polygon2.h"
#include "scan/yard/sheets.h"

namespace jalon::yard {

namespace {

constexpr double kRough_m = 0.02;            // of the ground's height, either way
constexpr double kReach_m = 15;              // of the ground, about the walls
constexpr double kStrip_m = 1, kTile_m = 1;  // along the walls, and beyond
constexpr double kTileApart_m = 1.75;        // of a tile's middle from a wall
constexpr double kEmptyBand_m = 0.3;         // between the wall's top and the roof
constexpr double kOverhang_m = 0.3, kFascia_m = 0.2, kSoffitInside_m = 0.2;
constexpr double kBush_m = 0.5, kLeaf_m = 0.06, kBushBefore_m = 1.0;
constexpr int kLeaves = 250, kHalfFacets = 12;
constexpr double kLongSide_m = 20;  // that has two bushes
constexpr uint64_t kGroundStream = 1ull << 32, kBushStream = 1ull << 33;

void add_strip(Sheets& out, uint32_t part, const Side& side, RandomStream& random) {
  for (double u = 0; u < side.length_m; u += 2 * kStrip_m) {
    const double z = kGround_m + kRough_m * (2 * random.uniform() - 1);
    const Vec3 o = side.wall.origin;
    out.rect(part, kRest, {{o.x, o.y, z}, side.wall.u, side.wall.normal() * -1},
             {u, std::min(u + 2 * kStrip_m, side.length_m), -kStrip_m, 0});
  }
}

double distance_to(const Plan& plan, const Vec2& p) {
  double nearest = INFINITY;
  for (const Side& side : plan.sides) {
    const Vec3 a = side.wall.point(0, 0), b = side.wall.point(side.length_m, 0);
    nearest = std::min(nearest, segment_distance(p, {a.x, a.y}, {b.x, b.y}));
  }
  return nearest;
}

bool is_free(const Plan& plan, const Vec2& p) {
  return std::none_of(plan.buildings.begin(), plan.buildings.end(), [&](const Building& b) {
    return contains(b.outline, p) || border_distance(b.outline, p) < kTileApart_m;
  });
}

void add_tiles(Sheets& out, uint32_t part, const Plan& plan, RandomStream& random) {
  Box3 box;
  for (const Side& side : plan.sides) {
    box.add(side.wall.point(0, 0));
    box.add(side.wall.point(side.length_m, 0));
  }
  for (double x = box.min.x - kReach_m; x < box.max.x + kReach_m; x += kTile_m)
    for (double y = box.min.y - kReach_m; y < box.max.y + kReach_m; y += kTile_m) {
      const double z = kGround_m + kRough_m * (2 * random.uniform() - 1);
      const Vec2 middle{x + kTile_m / 2, y + kTile_m / 2};
      if (distance_to(plan, middle) > kReach_m || !is_free(plan, middle)) continue;
      out.rect(part, kRest, {{x, y, z}, {1, 0, 0}, {0, 1, 0}}, {0, kTile_m, 0, kTile_m});
    }
}

// One height for all, above the highest wall: the text cuts all its walls at one gap.
void add_eaves(Sheets& out, uint32_t part, const Side& side, double highest_m) {
  const double z = highest_m + kEmptyBand_m;
  const Vec3 o = side.wall.origin;
  out.rect(part, kRest, {{o.x, o.y, z}, side.wall.u, side.wall.normal()},
           {0, side.length_m, -kSoffitInside_m, kOverhang_m});
  out.rect(part, kRest, side.wall.raised(kOverhang_m), {0, side.length_m, z, z + kFascia_m});
}

// The half that looks outward.
void add_gutter(Sheets& out, uint32_t part, const Gutter& g) {
  const Vec2 right{-g.outward.v, g.outward.u};
  const auto at = [&](int k) {
    const double angle = std::numbers::pi * (static_cast<double>(k) / kHalfFacets - 0.5);
    const Vec2 p =
        g.centre + (g.outward * std::cos(angle) + right * std::sin(angle)) * kGutterRadius_m;
    return Vec3{p.u, p.v, 0};
  };
  for (int k = 0; k < kHalfFacets; ++k) {
    const Vec3 a = at(k), b = at(k + 1);
    out.rect(part, kGutter, {a, normalized(b - a), {0, 0, 1}},
             {0, norm(b - a), kGround_m, kGutterTop_m});
  }
}

}  // namespace

void add_surroundings(Sheets& out, const Plan& plan, uint64_t seed) {
  RandomStream random(seed, kGroundStream);
  const uint32_t ground = out.part("ground", "ground"), roof = out.part("roof", "roof"),
                 gutters = out.part("gutters", "gutter");
  out.part("bushes", "tree");
  double highest_m = 0;
  for (const Side& side : plan.sides) highest_m = std::max(highest_m, side.top_m);
  for (const Side& side : plan.sides) {
    add_strip(out, ground, side, random);
    add_eaves(out, roof, side, highest_m);
  }
  add_tiles(out, ground, plan, random);
  for (const Gutter& g : plan.gutters) add_gutter(out, gutters, g);
  uint64_t number = 0;
  for (const Side& side : plan.sides)
    for (int k = 0; k < (side.length_m > kLongSide_m ? 2 : 1); ++k) {
      RandomStream leaves(seed, kBushStream + ++number);
      const double u = side.length_m * leaves.uniform();
      const Vec3 middle = side.wall.point(u, kGround_m + kBush_m, kBushBefore_m);
      out.crown(middle, kBush_m, kLeaves, kLeaf_m, leaves);
    }
}

}  // namespace jalon::yard
