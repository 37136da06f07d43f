// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/region_relation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon2.h"

namespace jalon {

namespace {

using enum NineIntersection::Place;
using RegionEdge = PlaneRegion::Edge;

void add_region_edges(const std::vector<Vec2>& ring, std::vector<RegionEdge>& out) {
  for (size_t i = 0; i < ring.size(); ++i) out.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

std::vector<RegionEdge> region_edges(const PolygonWithHoles& polygon) {
  std::vector<RegionEdge> out;
  add_region_edges(polygon.outline, out);
  for (const auto& hole : polygon.holes) add_region_edges(hole, out);
  return out;
}

// The middle of the widest stretch inside on the level line through the widest gap between the corners' heights.
Vec2 inner_point(const PolygonWithHoles& polygon) {
  const std::vector<RegionEdge> edges = region_edges(polygon);
  std::vector<double> heights;
  for (const RegionEdge& e : edges) heights.push_back(e.from.v);
  std::sort(heights.begin(), heights.end());
  double level = heights[0], gap = 0;
  for (size_t i = 1; i < heights.size(); ++i)
    if (heights[i] - heights[i - 1] > gap) {
      gap = heights[i] - heights[i - 1];
      level = (heights[i] + heights[i - 1]) / 2;
    }
  std::vector<double> crossings;
  for (const RegionEdge& e : edges)
    if ((e.from.v < level) != (e.to.v < level))
      crossings.push_back(e.at((level - e.from.v) / (e.to.v - e.from.v)).u);
  std::sort(crossings.begin(), crossings.end());
  Vec2 best{edges[0].from};
  double widest = -1;
  for (size_t i = 0; i + 1 < crossings.size(); i += 2)
    if (crossings[i + 1] - crossings[i] > widest) {
      widest = crossings[i + 1] - crossings[i];
      best = {(crossings[i] + crossings[i + 1]) / 2, level};
    }
  return best;
}

// Step 1: pieces of A's border, each on, in or out of B.
void judge_border(const PlaneRegion& a, const PlaneRegion& b, double tolerance,
                  NineIntersection& out) {
  for (const RegionEdge& edge : a.edges()) {
    const std::vector<double> cuts = cuts_of(edge, b.edges(), tolerance);
    for (const double t : cuts)
      if (b.border_distance(edge.at(t)) <= tolerance) out.raise(kBoundary, kBoundary, 0);
    const double length = norm(edge.to - edge.from);
    for (size_t k = 0; k + 1 < cuts.size(); ++k) {
      Vec2 farthest{};
      double far = -1;
      for (const double share : {0.25, 0.5, 0.75}) {
        const Vec2 p = edge.at(cuts[k] + share * (cuts[k + 1] - cuts[k]));
        if (const double d = b.border_distance(p); d > far) far = d, farthest = p;
      }
      if (far > tolerance) out.raise(kBoundary, b.contains(farthest) ? kInterior : kExterior, 1);
      else if ((cuts[k + 1] - cuts[k]) * length > 2 * tolerance) out.raise(kBoundary, kBoundary, 1);
    }
  }
}

// Step 2: where no border runs through an interior, each piece of that lies wholly in or out of the other region.
void judge_interior(const PlaneRegion& a, const PlaneRegion& b, NineIntersection& out) {
  if (!out.is_empty(kBoundary, kInterior)) out.raise(kInterior, kInterior, 2);
  if (!out.is_empty(kBoundary, kExterior)) out.raise(kInterior, kExterior, 2);
  if (!out.is_empty(kInterior, kBoundary)) {
    out.raise(kInterior, kInterior, 2);
    out.raise(kInterior, kExterior, 2);
    return;
  }
  for (const Vec2& p : a.inner_points())
    out.raise(kInterior, b.contains(p) ? kInterior : kExterior, 2);
}

}  // namespace

PlaneRegion::PlaneRegion(std::span<const PolygonWithHoles> polygons) : polygons_(polygons) {
  for (const PolygonWithHoles& polygon : polygons) {
    const auto more = region_edges(polygon);
    edges_.insert(edges_.end(), more.begin(), more.end());
  }
}

bool PlaneRegion::contains(const Vec2& p) const {
  return std::any_of(polygons_.begin(), polygons_.end(), [&](const PolygonWithHoles& polygon) {
    return jalon::contains(polygon.outline, p) &&
           std::none_of(polygon.holes.begin(), polygon.holes.end(),
                        [&](const auto& hole) { return jalon::contains(hole, p); });
  });
}

double PlaneRegion::border_distance(const Vec2& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const RegionEdge& e : edges_) least = std::min(least, segment_distance(p, e.from, e.to));
  return least;
}

NineIntersection::Place PlaneRegion::place_of(const Vec2& p, double tolerance) const {
  if (border_distance(p) <= tolerance) return kBoundary;
  return contains(p) ? kInterior : kExterior;
}

std::vector<Vec2> PlaneRegion::inner_points() const {
  std::vector<Vec2> out;
  for (const PolygonWithHoles& polygon : polygons_)
    if (polygon.outline.size() >= 3) out.push_back(inner_point(polygon));
  return out;
}

std::vector<double> cuts_of(const RegionEdge& edge, std::span<const RegionEdge> others,
                            double tolerance) {
  std::vector<double> out{0, 1};
  const Vec2 along = edge.to - edge.from;
  const double squared = dot(along, along);
  if (!(squared > 0)) return out;
  const auto add = [&](double t) {
    if (t > 0 && t < 1) out.push_back(t);
  };
  for (const RegionEdge& other : others) {
    const Vec2 step = other.to - other.from, apart = other.from - edge.from;
    const double sine = cross(along, step);
    if (sine != 0)
      if (const double s = cross(apart, along) / sine; s >= 0 && s <= 1)
        add(cross(apart, step) / sine);
    // A corner beside the edge begins or ends a stretch along it.
    for (const Vec2& corner : {other.from, other.to})
      if (std::fabs(cross(along, corner - edge.from)) <= tolerance * std::sqrt(squared))
        add(dot(along, corner - edge.from) / squared);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

NineIntersection region_intersection(std::span<const PolygonWithHoles> a,
                                     std::span<const PolygonWithHoles> b, double tolerance) {
  const PlaneRegion first(a), second(b);
  NineIntersection out;
  // 1. Both borders.
  judge_border(first, second, tolerance, out);
  NineIntersection reverse = out.transposed();
  judge_border(second, first, tolerance, reverse);
  out = reverse.transposed();
  // 2. Both interiors.
  judge_interior(first, second, out);
  reverse = out.transposed();
  judge_interior(second, first, reverse);
  out = reverse.transposed();
  // 3. Regions are bounded, the plane is not.
  out.raise(kExterior, kExterior, 2);
  return out;
}

}  // namespace jalon
