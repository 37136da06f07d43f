// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/nine_intersection.h"
#include "model/relations/placed_face.h"

namespace jalon {

/// A volume as the faces that enclose it, their normals outward.
struct PlacedSolid {
  std::vector<PlacedFace> faces;
  std::vector<std::array<Vec3, 3>> triangles;  ///< of the faces, anticlockwise seen from outside
  Box3 box;

  /// Of the sum of solid angles (van Oosterom & Strackee 1983); for points off the faces.
  bool contains(const Vec3& p) const;
};

PlacedSolid placed_solid(const Model& model, const Solid& solid, double chord_error_m);

/// The 9-intersection of two volumes: borders are surfaces, interiors and exteriors volumes. Each face is cut by the
/// other's faces, and points on both sides of every piece of the cuts tell where the parts of the face lie; interiors
/// follow, for an interior that no face of the other runs through lies wholly in or out of it. O(n m) pairs of faces.
NineIntersection solid_intersection(const PlacedSolid& a, const PlacedSolid& b, double tolerance);

/// Least distance between points of two volumes, 0 where they share any.
double solid_distance(const PlacedSolid& a, const PlacedSolid& b, double tolerance);

}  // namespace jalon
