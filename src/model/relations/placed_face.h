// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/plane.h"
#include "geometry/polygon_sets.h"
#include "model/model.h"
#include "model/polygon_triangles.h"

namespace jalon {

/// A flat polygon with holes where it stands in space, its arcs as chords.
struct PlacedFace {
  Plane plane;
  Vec3 origin;  ///< of the plane coordinates: a corner
  PlaneAxes axes;
  PolygonWithHoles polygon;  ///< in the plane
  Box3 box;

  Vec2 project(const Vec3& p) const { return axes.project(p, origin); }
  Vec3 lift(const Vec2& p) const { return origin + axes.u * p.u + axes.v * p.v; }
};

/// A polygon in space as it lies in the plane of its corners; rings[0] is the outline. Chords of arcs are the caller's.
PlacedFace placed(const std::vector<std::vector<Vec3>>& rings, const Vec3& normal);

/// A face of a model, its arcs as chords within chord_error_m.
PlacedFace placed_face(const Model& model, const Face& face, double chord_error_m);
/// What fills a hole of a face: the ring as an outline.
PlacedFace placed_filling(const Model& model, const Face& face, const Ring& hole,
                          double chord_error_m);

/// All ring corners in space.
std::vector<Vec3> corners_of(const PlacedFace& face);
/// Are all corners of each within tolerance of the other's plane?
bool are_coplanar(const PlacedFace& a, const PlacedFace& b, double tolerance);
/// The polygon of a face as it lies in the plane coordinates of another, seen along that one's normal.
PolygonWithHoles seen_in(const PlacedFace& face, const PlacedFace& frame);

/// Are both boxes within reach of each other?
bool are_near(const Box3& a, const Box3& b, double reach);
/// Least distance of two boxes.
double box_distance(const Box3& a, const Box3& b);

}  // namespace jalon
