// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/facades.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/polygon2.h"
#include "spatial/union_find.h"

namespace jalon {

namespace {

constexpr double kSameFacade_rad = std::numbers::pi / 180, kSameFacade_m = 0.02;

double mean_offset(const VerticalPiece& piece, const Vec3& normal) {
  double sum = 0;
  for (const Vec3& p : piece.corners) sum += dot(normal, p);
  return sum / static_cast<double>(piece.corners.size());
}

struct Span2 {
  double from = std::numeric_limits<double>::infinity(),
         to = -std::numeric_limits<double>::infinity();
  void add(double v) {
    from = std::min(from, v);
    to = std::max(to, v);
  }
};

Span2 span_along(const VerticalPiece& piece, const Vec3& along) {
  Span2 span;
  for (const Vec3& p : piece.corners) span.add(dot(along, p));
  return span;
}

bool are_one_facade(const VerticalPiece& a, const VerticalPiece& b) {
  if (a.building != b.building || dot(a.normal, b.normal) < std::cos(kSameFacade_rad)) return false;
  for (const Vec3& p : b.corners)
    if (std::fabs(dot(a.normal, p) - mean_offset(a, a.normal)) > kSameFacade_m) return false;
  const Vec3 along{-a.normal.y, a.normal.x, 0};
  const Span2 sa = span_along(a, along), sb = span_along(b, along);
  return sa.from <= sb.to + kSameFacade_m && sb.from <= sa.to + kSameFacade_m;
}

// Groups of pieces: each face by itself, triangles by plane. Those of one plane lie together when
// sorted by building, direction and offset.
std::vector<std::vector<uint32_t>> facade_groups(const std::vector<VerticalPiece>& pieces) {
  std::vector<uint32_t> order;
  std::vector<std::vector<uint32_t>> groups;
  for (uint32_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].face == kNoFace) order.push_back(i);
    else groups.push_back({i});
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return pieces[a].building < pieces[b].building; });
  UnionFind joined(pieces.size());
  for (size_t i = 0; i < order.size(); ++i)
    for (size_t j = i + 1;
         j < order.size() && pieces[order[j]].building == pieces[order[i]].building; ++j)
      if (are_one_facade(pieces[order[i]], pieces[order[j]])) joined.join(order[i], order[j]);
  std::vector<uint32_t> group_of(pieces.size(), kNoFace);
  for (const uint32_t i : order) {
    uint32_t& group = group_of[joined.find(i)];
    if (group == kNoFace) group = static_cast<uint32_t>(groups.size()), groups.emplace_back();
    groups[group].push_back(i);
  }
  return groups;
}

std::vector<Vec2> counter_clockwise(std::vector<Vec2> ring) {
  if (signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

BuildingFacade facade_of(const std::vector<VerticalPiece>& pieces,
                         const std::vector<uint32_t>& group) {
  BuildingFacade facade;
  facade.building = pieces[group.front()].building;
  facade.normal = pieces[group.front()].normal;
  size_t corners = 0;
  for (const uint32_t i : group) {
    facade.offset_m +=
        mean_offset(pieces[i], facade.normal) * static_cast<double>(pieces[i].corners.size());
    corners += pieces[i].corners.size();
  }
  facade.offset_m /= static_cast<double>(corners);
  Span2 along, up;
  for (const uint32_t i : group) {
    std::vector<Vec2> ring;
    for (const Vec3& p : pieces[i].corners) {
      ring.push_back({dot(facade.along(), p), p.z});
      along.add(ring.back().u);
      up.add(p.z);
    }
    facade.pieces.push_back(counter_clockwise(std::move(ring)));
  }
  facade.from_m = along.from, facade.to_m = along.to;
  facade.bottom_m = up.from, facade.top_m = up.to;
  return facade;
}

Vec2 flat(const Vec3& p) { return {p.x, p.y}; }
Vec2 base_start(const BuildingFacade& f) { return flat(f.place({f.from_m, 0})); }
Vec2 base_end(const BuildingFacade& f) { return flat(f.place({f.to_m, 0})); }

// How often the line from p along the direction crosses the segment: half-open, so that a corner of
// two segments counts once.
bool crosses(const Vec2& p, const Vec2& direction, const Vec2& a, const Vec2& b) {
  const double sa = cross(direction, a - p), sb = cross(direction, b - p);
  if ((sa >= 0) == (sb >= 0)) return false;
  const Vec2 at = a + (b - a) * (sa / (sa - sb));
  return dot(direction, at - p) > 0;
}

BuildingFacade turned(const BuildingFacade& f) {
  BuildingFacade t = f;
  t.normal = -f.normal;
  t.offset_m = -f.offset_m;
  t.from_m = -f.to_m, t.to_m = -f.from_m;
  for (auto& ring : t.pieces) {
    for (Vec2& p : ring) p.u = -p.u;
    ring = counter_clockwise(std::move(ring));
  }
  t.was_turned = true;
  return t;
}

}  // namespace

std::vector<BuildingFacade> facades_of(const VerticalPieces& pieces, double least_length_m) {
  std::vector<BuildingFacade> made;
  for (const auto& group : facade_groups(pieces.pieces)) {
    BuildingFacade facade = facade_of(pieces.pieces, group);
    if (facade.to_m - facade.from_m >= least_length_m) made.push_back(std::move(facade));
  }
  return made;
}

void turn_outward(std::vector<BuildingFacade>& facades) {
  std::vector<std::vector<uint32_t>> of_building;
  for (uint32_t i = 0; i < facades.size(); ++i) {
    if (facades[i].building >= of_building.size()) of_building.resize(facades[i].building + 1);
    of_building[facades[i].building].push_back(i);
  }
  std::vector<bool> inward(facades.size(), false);
  for (const auto& own : of_building)
    for (const uint32_t i : own) {
      const Vec2 middle = (base_start(facades[i]) + base_end(facades[i])) * 0.5;
      const Vec2 out = flat(facades[i].normal);
      int before = 0, behind = 0;
      for (const uint32_t j : own) {
        if (j == i) continue;
        before += crosses(middle, out, base_start(facades[j]), base_end(facades[j]));
        behind += crosses(middle, out * -1, base_start(facades[j]), base_end(facades[j]));
      }
      inward[i] = before % 2 == 1 && behind % 2 == 0;
    }
  for (uint32_t i = 0; i < facades.size(); ++i)
    if (inward[i]) facades[i] = turned(facades[i]);
}

}  // namespace jalon
