// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/polygon2.h"
#include "model/buildings/facades.h"
#include "spatial/union_find.h"

namespace jalon {

namespace {

struct BaseLine {
  Vec2 a, b;
  uint32_t building = 0;
};

bool come_near(const BaseLine& s, const BaseLine& t, double touch_m) {
  if (segments_meet(s.a, s.b, t.a, t.b)) return true;
  return segment_distance(s.a, t.a, t.b) <= touch_m || segment_distance(s.b, t.a, t.b) <= touch_m ||
         segment_distance(t.a, s.a, s.b) <= touch_m || segment_distance(t.b, s.a, s.b) <= touch_m;
}

// Over more than a corner: the part of t within touch_m of s is longer than what a crossing has.
bool run_along(const BaseLine& s, const BaseLine& t, double touch_m) {
  const Vec2 along = s.b - s.a;
  const double length = norm(along);
  if (!(length > 0)) return false;
  const Vec2 way = along * (1 / length);
  constexpr double kParallel = 0.1;  // sine: 6 degrees
  if (std::fabs(cross(way, t.b - t.a)) > kParallel * norm(t.b - t.a)) return false;
  if (std::fabs(cross(way, t.a - s.a)) > touch_m && std::fabs(cross(way, t.b - s.a)) > touch_m)
    return false;
  const double from = std::max(0.0, std::min(dot(way, t.a - s.a), dot(way, t.b - s.a)));
  const double to = std::min(length, std::max(dot(way, t.a - s.a), dot(way, t.b - s.a)));
  return to - from > 2 * touch_m;
}

}  // namespace

Blocks blocks_of(const std::vector<BuildingFacade>& facades, size_t buildings, double touch_m,
                 bool corners) {
  // 1. Base lines into the cells that their boxes cover.
  constexpr double kCell_m = 20;  // about a house
  std::vector<BaseLine> lines;
  std::map<std::pair<int64_t, int64_t>, std::vector<uint32_t>> cells;
  for (const BuildingFacade& f : facades) {
    const Vec3 start = f.place({f.from_m, 0}), end = f.place({f.to_m, 0});
    const auto cell = [](double v) { return static_cast<int64_t>(std::floor(v / kCell_m)); };
    for (int64_t x = cell(std::min(start.x, end.x) - touch_m);
         x <= cell(std::max(start.x, end.x) + touch_m); ++x)
      for (int64_t y = cell(std::min(start.y, end.y) - touch_m);
           y <= cell(std::max(start.y, end.y) + touch_m); ++y)
        cells[{x, y}].push_back(static_cast<uint32_t>(lines.size()));
    lines.push_back({{start.x, start.y}, {end.x, end.y}, f.building});
  }
  // 2. Buildings whose lines touch.
  UnionFind joined(buildings);
  for (const auto& [place, inside] : cells)
    for (size_t i = 0; i < inside.size(); ++i)
      for (size_t j = i + 1; j < inside.size(); ++j) {
        const BaseLine &s = lines[inside[i]], &t = lines[inside[j]];
        if (joined.find(s.building) == joined.find(t.building)) continue;
        if (corners ? come_near(s, t, touch_m)
                    : run_along(s, t, touch_m) || run_along(t, s, touch_m))
          joined.join(s.building, t.building);
      }
  // 3. Numbered as they come.
  Blocks made;
  std::vector<uint32_t> number(buildings, kNoFace);
  for (uint32_t b = 0; b < buildings; ++b) {
    uint32_t& n = number[joined.find(b)];
    if (n == kNoFace) n = made.count++;
    made.of_building.push_back(n);
  }
  return made;
}

}  // namespace jalon
