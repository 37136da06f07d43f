// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/edges/find/edge_shape.h"
#include "modelling/plane/near_points.h"

namespace jalon {

/// A point of the plane next to an edge.
struct StripPoint {
  double d_m;  ///< depth into the solid
  double
      weight;  ///< so that the density of a homogeneous solid does not depend on the depth (arcs)
};

/// A piece of an edge with the points of the plane across it.
struct EdgeBlock {
  double t_m = 0, length_m = 0;    ///< its middle and length along the edge
  double depth_m = 0;              ///< the solid is free of other edges so deep
  double outward_m = 0;            ///< and the outside so far
  std::vector<StripPoint> points;  ///< ascending depth
};

/// A point of the cloud off the plane, next to an edge.
struct RevealPoint {
  double t_m, d_m, height_m;
};

/// An edge and all that was measured about it.
struct MeasuredEdge {
  EdgeShape shape;
  double moved_m = 0;  ///< from its contour's place, into the solid
  std::vector<EdgeBlock> blocks;
  std::vector<RevealPoint> behind, before;  ///< the plane
};

/// Across an edge, in spacings: how far the strips of collect_blocks reach.
constexpr double kStripOutward = 2.5, kStripInward = 9;

/// Contour points of all rings of a plane: where other edges are.
PointRows contour_points(std::span<const std::vector<Vec2>> rings, double spacing_m, Task& task);

/// Cuts the edge, less its ends, into blocks and takes up the points next to it. min_height_m: of
/// points off the plane.
///
/// Before: near and contours reach kStripOutward and kStripInward from the edge. After: blocks in
/// ascending t, 256 at most, none on an edge shorter than three spacings; behind and before are
/// filled anew. O(points near the edge).
void collect_blocks(const NearPoints& near, const PointRows& contours, double spacing_m,
                    double min_height_m, MeasuredEdge& edge);

}  // namespace jalon
