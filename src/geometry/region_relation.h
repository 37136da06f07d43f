// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/nine_intersection.h"
#include "geometry/polygon_sets.h"

namespace jalon {

/// A closed region of the plane as its edges, and where a point lies to it.
class PlaneRegion {
 public:
  struct Edge {
    Vec2 from, to;
    Vec2 at(double t) const { return from + (to - from) * t; }
  };

  explicit PlaneRegion(std::span<const PolygonWithHoles> polygons);

  const std::vector<Edge>& edges() const { return edges_; }
  /// Of the closed region; on the border either.
  bool contains(const Vec2& p) const;
  double border_distance(const Vec2& p) const;
  NineIntersection::Place place_of(const Vec2& p, double tolerance) const;
  /// One point inside each polygon, away from its border.
  std::vector<Vec2> inner_points() const;

 private:
  std::span<const PolygonWithHoles> polygons_;
  std::vector<Edge> edges_;
};

/// Places 0 = from ... 1 = to of an edge where others cross it or begin beside it; ascending, both ends among them.
std::vector<double> cuts_of(const PlaneRegion::Edge& edge,
                            std::span<const PlaneRegion::Edge> others, double tolerance);

/// The 9-intersection of two regions of the plane (Egenhofer & Herring 1990): each edge is cut where the other border
/// meets it, and each piece judged by where it lies. What lies within tolerance of a border is on it, so that shapes
/// which differ by less are equal.
///
/// Before: polygons of a region share no inner points and no edges (combined() makes them so). O(n m) for n and m
/// edges.
NineIntersection region_intersection(std::span<const PolygonWithHoles> a,
                                     std::span<const PolygonWithHoles> b, double tolerance);

}  // namespace jalon
