// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// The 2D Delaunay triangulation of a few points, made as far as it is asked for: first the triangles about one point,
/// then those across one edge after the other. The whole of it is delaunay()'s, where no four nodes lie on one circle.
///
/// - Points are snapped to a grid of grid_m about the lowest corner of their box; every decision is exact. Of the
///   points on one node the first takes part.
/// - Nodes on one circle are split as a fan about the first of them, whatever the order of asking.
/// - O(n) a triangle, for n points; faster than delaunay() as long as few triangles are asked for.
/// Source: gift wrapping, McLain 1976; the apex of an edge is the point that sees it under the largest angle.
class GrowingDelaunay {
 public:
  /// Triangles are known to its left, none yet to its right.
  struct Edge {
    uint32_t from, to;
    bool operator==(const Edge&) const = default;
  };

  /// Makes the triangles about points[centre], anticlockwise. Coordinates must be finite and span less than 2^26 steps:
  /// else Error(kLimit).
  void start(std::span<const Vec2> points, double grid_m, uint32_t centre);
  /// Makes the triangle across the edge border()[edge], behind the others; false where there is none, on the hull.
  /// Either way the edge leaves the border, the order of which may change.
  bool grow(size_t edge);

  /// Indices of the points, anticlockwise. None where all points lie on one line.
  std::span<const std::array<uint32_t, 3>> triangles() const { return triangles_; }
  std::span<const Edge> border() const { return border_; }

 private:
  void snap(std::span<const Vec2> points, double grid_m);
  uint32_t nearest_node(uint32_t centre) const;
  uint32_t apex(uint32_t a, uint32_t b) const;
  uint32_t apex_among_equal(uint32_t a, uint32_t b, double least) const;
  uint32_t first_on_node(uint32_t i) const;
  int64_t turn(uint32_t a, uint32_t b, uint32_t c) const;
  void toggle(Edge edge);

  std::vector<double> x_, y_;  ///< grid steps; up to a multiple of the lanes NaN
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<Edge> border_;
};

}  // namespace jalon
